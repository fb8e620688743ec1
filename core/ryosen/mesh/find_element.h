// A vertex, edge, halfedge or face by its name.
#pragma once

#include <string_view>

#include "ryosen/base/element.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

struct NamedElement {
  std::optional<Element> element;
  NameError error = NameError::none;
  Text sentence;
};
// fN is a face, vN a vertex, hN a halfedge, all else an edge.
NamedElement find_element(const Mesh& mesh, std::string_view name);

// Whether a word is written as the name of a vertex, an edge or a face, whatever mesh it may be about.
bool is_vertex_name(std::string_view word);
bool is_edge_name(std::string_view word);
bool is_face_name(std::string_view word);
inline bool is_element_name(std::string_view word) {
  return is_face_name(word) || is_vertex_name(word) || is_edge_name(word);
}

// Whether it is an element of the mesh as it is; not one without a slot.
bool is_alive(const Mesh& mesh, const Element& element);
// Whether a mesh of these lengths has its slot, alive or not.
bool has_slot(const ColumnLengths& lengths, const Element& element);

}  // namespace ryosen
