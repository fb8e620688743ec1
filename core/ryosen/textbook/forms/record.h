// The record that a form stores of one element: its fields in the order of the source text's table, with the text's own
// words.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/element.h"

namespace ryosen::forms {

// A link to an element, several, or places. In what a form returns the links hold the form's own numbers; in what
// Records (records.h) returns they hold slots of the mesh. A link without an index leads nowhere.
struct Field {
  std::string_view key;   // Ryosen's word, the same in every form
  std::string_view word;  // the source text's
  bool is_list = false;   // whether it holds a list of links; places are one of a vertex, or several
  std::vector<Element> links;
  std::vector<glm::dvec3> places;
  // The stored value of each link; nullopt for none. Differs from the link's number where the form codes it.
  std::vector<std::optional<std::int64_t>> stored;
};
using Fields = std::vector<Field>;

inline std::optional<std::int64_t> stored_number(std::uint32_t number) {
  return number == no_index ? std::nullopt : std::optional<std::int64_t>(number);
}

template <class Handle>
Field link(std::string_view key, std::string_view word, Handle to) {
  return {key, word, false, {Element(to)}, {}, {stored_number(to.index)}};
}
template <class Handle>
Field links(std::string_view key, std::string_view word, const std::vector<Handle>& to) {
  Field field{key, word, true, {}, {}, {}};
  for (const Handle one : to) {
    field.links.push_back(Element(one));
    field.stored.push_back(stored_number(one.index));
  }
  return field;
}
inline Field place(std::string_view word, const glm::dvec3& at) { return {"position", word, false, {}, {at}, {}}; }
inline Field places(std::string_view word, std::vector<glm::dvec3> at) {
  return {"positions", word, true, {}, std::move(at), {}};
}

}  // namespace ryosen::forms
