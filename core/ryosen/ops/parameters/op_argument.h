// An argument of an operator's line: a word of text, or an element or a position as it is, where no text was written.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ryosen/base/element.h"

namespace ryosen {

class Mesh;

class OpArgument {
 public:
  OpArgument(std::string_view word) : value_(word) {}
  OpArgument(const Element& element) : value_(element) {}
  OpArgument(const glm::dvec3& position) : value_(position) {}
  // Any element of a kind: it can be matched with a line, but not read.
  OpArgument(Element::Kind any) : value_(Element(any)) {}

  bool is_word() const { return std::holds_alternative<std::string_view>(value_); }
  // Empty, or null, where the argument is something else.
  std::string_view word() const { return is_word() ? std::get<std::string_view>(value_) : std::string_view(); }
  const Element* element() const { return std::get_if<Element>(&value_); }
  const glm::dvec3* position() const { return std::get_if<glm::dvec3>(&value_); }

 private:
  std::variant<std::string_view, Element, glm::dvec3> value_;
};

// Words, and elements or a kind of them before the words.
std::vector<OpArgument> op_arguments(std::span<const std::string_view> words);
std::vector<OpArgument> op_arguments(std::span<const Element> elements, std::span<const std::string_view> words = {});
std::vector<OpArgument> op_arguments(Element::Kind kind, std::size_t count, std::span<const std::string_view> words);

// Prints an argument as a line has it: an element by its name, a vertex as a copy of its point.
std::string print_argument(const Mesh& mesh, const OpArgument& argument);

}  // namespace ryosen
