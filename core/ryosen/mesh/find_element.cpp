#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

// Names are checked for their syntax only.
const Mesh& mesh_without_elements() {
  static const Mesh mesh;
  return mesh;
}

// Checks the part before `@`, and the face after it if present.
template <class Find>
bool is_name(std::string_view word, Find find) {
  const std::size_t at = word.find('@');
  return find(mesh_without_elements(), word).error != NameError::malformed &&
         (at == std::string_view::npos || is_face_name(word.substr(at + 1)));
}

}  // namespace

bool is_vertex_name(std::string_view word) { return is_name(word, find_vertex); }
bool is_edge_name(std::string_view word) { return is_name(word, find_edge); }
bool is_face_name(std::string_view word) {
  return find_face(mesh_without_elements(), word).error != NameError::malformed;
}

NamedElement find_element(const Mesh& mesh, std::string_view name) {
  const auto as = [](auto named, auto element_of) -> NamedElement {
    if (!named.ok()) return {std::nullopt, named.error, std::move(named.sentence)};
    return {element_of(named.element), NameError::none, {}};
  };
  if (name.starts_with('f')) return as(find_face(mesh, name), [](Face f) { return Element(f); });
  if (name.starts_with('v')) return as(find_vertex(mesh, name), [](Vertex v) { return Element(v); });
  const bool is_half = name.starts_with('h');
  return as(find_edge(mesh, name), [&](Halfedge h) { return is_half ? Element(h) : Element(edge(h)); });
}

bool is_alive(const Mesh& mesh, const Element& element) {
  return element.visit([&](auto handle) { return mesh.exists(handle) && mesh.is_alive(handle); });
}

bool has_slot(const ColumnLengths& lengths, const Element& element) {
  const std::uint32_t slots[] = {lengths.vertices, lengths.halfedges, lengths.halfedges / 2, lengths.faces};
  return element.index < slots[static_cast<std::size_t>(element.kind)];
}

}  // namespace ryosen
