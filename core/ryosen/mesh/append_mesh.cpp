#include "ryosen/mesh/append_mesh.h"

#include <cassert>

#include "ryosen/mesh/attribute.h"

namespace ryosen {

namespace {

bool is_value_of_its_own(const AttributeColumn& column) {
  using namespace attribute_names;
  return !is_reserved_name(column.name) || column.name == colour || column.name == weight ||
         column.name == face_colour || column.name == face_colour_components;
}

// Of one kind of elements, from this slot of the mesh on.
void copy_attributes(Edit& edit, const Mesh& part, AppendedAttributes attributes, ElementKind kind, std::uint32_t first,
                     std::uint32_t count) {
  for (std::size_t i = 0; i < edit.mesh().attributes().size(); ++i) {
    const AttributeColumn& column = edit.mesh().attributes()[i];
    const AttributeColumn* const same = column.is_of(kind) ? find_column(part, column.name) : nullptr;
    if (!same || same->type != column.type) continue;
    if (attributes == AppendedAttributes::values && !is_value_of_its_own(column)) continue;
    const std::span words = same->data;
    for (std::uint32_t k = 0; k < count; ++k)
      edit.set_attribute(i, first + k, words.subspan(std::size_t{k} * column.words(), column.words()));
  }
}

}  // namespace

void append_mesh(Edit& edit, const Mesh& part, AppendedAttributes attributes) {
  assert(part.live().vertices == part.vertex_slots() && part.live().edges == part.edge_slots() &&
         part.live().faces == part.face_slots());
  const std::uint32_t vertices = edit.mesh().vertex_slots(), halfedges = edit.mesh().halfedge_slots(),
                      faces = edit.mesh().face_slots();
  const auto moved = [](auto element, std::uint32_t by) {
    return element ? decltype(element)(element.index + by) : element;
  };
  for (std::uint32_t i = 0; i < part.vertex_slots(); ++i) {
    const Vertex v = edit.add_vertex(part.position(Vertex(i)));
    edit.fresh(v);
    edit.set_halfedge(v, moved(part.halfedge(Vertex(i)), halfedges));
  }
  for (std::uint32_t i = 0; i < part.edge_slots(); ++i) {
    const Halfedge h = halfedge(Edge(i));
    edit.fresh(edge(edit.add_edge(moved(part.from(h), vertices), moved(part.to(h), vertices))));
  }
  for (std::uint32_t i = 0; i < part.halfedge_slots(); ++i) {
    const Halfedge h(i), added = moved(h, halfedges);
    edit.connect(added, moved(part.next(h), halfedges));
    edit.set_face(added, moved(part.face(h), faces));
    edit.fresh(added);
  }
  for (std::uint32_t i = 0; i < part.face_slots(); ++i) {
    const Face f = edit.add_face(moved(part.halfedge(Face(i)), halfedges));
    edit.fresh(f);
    for (std::uint32_t r = part.first_ring(Face(i)); r != no_index; r = part.ring(r).next)
      edit.add_ring(f, moved(part.ring(r).halfedge, halfedges));
  }
  for (std::uint32_t i = 0; part.has_copies() && i < part.vertex_slots(); ++i)
    if (const Vertex v(i); part.next_copy(v) != v)
      edit.set_copy_links(moved(v, vertices), moved(part.next_copy(v), vertices), moved(part.copy_point(v), vertices));
  if (attributes == AppendedAttributes::none) return;
  copy_attributes(edit, part, attributes, ElementKind::vertex, vertices, part.vertex_slots());
  copy_attributes(edit, part, attributes, ElementKind::edge, halfedges / 2, part.edge_slots());
  copy_attributes(edit, part, attributes, ElementKind::corner, halfedges, part.halfedge_slots());
  copy_attributes(edit, part, attributes, ElementKind::face, faces, part.face_slots());
}

}  // namespace ryosen
