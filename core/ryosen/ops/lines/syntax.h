// Checks an operator's arguments against its syntax string, without a mesh.
//
//   A-B [start|end|mid|X,Y,Z]     blanks between arguments, [ ] around optional ones, `|` between alternatives for one
//   A B C ... | fN                argument, ` | ` between whole lists, ... repeats the argument before it
//
// A name with `-` is an edge, fN and fM are faces, t and DISTANCE are numbers, X,Y,Z is a position; other lower-case
// words are literal, as is `-` alone; all else is a vertex.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace ryosen {

// The index of the first word that does not match: words.size() if one is missing, none if all match. Cost: the words
// times the length of the syntax.
std::optional<std::size_t> first_misfit(std::string_view syntax, std::span<const std::string_view> words);

// Whether a word is syntactically a vertex, edge or face name.
bool is_element_name(std::string_view word);

}  // namespace ryosen
