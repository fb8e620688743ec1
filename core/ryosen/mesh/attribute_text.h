// Attributes and their values as words of files and commands.
//
//   NAME            TYPE [RULE [NUMBER...]]
//   vertex.load     float blend 0              the numbers are the default value
//   face.tag        uchar greatest 255
//   edge.axis       doublex3 blend 0 0 1       three numbers in a row
//   corner.fixed    bool first false
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ryosen/base/message.h"
#include "ryosen/mesh/columns.h"

namespace ryosen {

inline constexpr std::uint32_t most_numbers_in_a_value = 1024;

// The scalar with a name of PLY, in either spelling (float, float32), or bool.
std::optional<Scalar> find_scalar(std::string_view word);
std::string_view name_of(Scalar scalar);
std::string name_of(ValueType type);
std::string_view name_of(ValueRule rule);
// vertex, edge, corner, face, pool.
std::string_view name_of(ElementKind element);
// The kind that the name of an attribute begins with, before a full stop and at least one character more. None for
// anything else, names with blanks or control characters, and pools.
std::optional<ElementKind> element_of_attribute(std::string_view name);
// The name behind the full stop.
std::string_view short_name(const AttributeColumn& column);

// The rule that a type has where none is told: blend for floats and doubles, first for the rest.
constexpr ValueRule usual_rule(ValueType type) {
  return is_floating(type.scalar) ? ValueRule::blend : ValueRule::first;
}

// A word that does not fit, and the sentence that continues it: "flout" + " is no type of values".
struct WordFault {
  std::string_view word;
  Text rest;
};

// An attribute without values from the words NAME TYPE [RULE [NUMBER...]]; the usual rule, and zeros, where these are
// missing.
struct ReadAttribute {
  AttributeColumn column;
  std::optional<WordFault> fault;
};
ReadAttribute read_attribute(std::span<const std::string_view> words);
// Its inverse. An own rule has no word: the usual one is written.
std::string words_of(const AttributeColumn& column);

// Reads the numbers of a value, one word each; integers must be in the range of their type.
std::optional<WordFault> read_value(ValueType type, std::span<const std::string_view> words,
                                    std::span<std::uint32_t> value);
// Its inverse, with blanks between the numbers. Reals have the fewest digits that give them back.
std::string value_text(ValueType type, const std::uint32_t* value);

}  // namespace ryosen
