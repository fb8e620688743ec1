#include "core/mesh/append_mesh.h"

#include <cassert>

namespace ryosen {

void append_mesh(Edit& edit, const Mesh& part) {
  assert(!part.has_copies() && !part.has_rings());
  assert(part.live().vertices == part.vertex_slots() && part.live().edges == part.edge_slots() &&
         part.live().faces == part.face_slots());
  const std::uint32_t vertices = edit.mesh().vertex_slots(), halfedges = edit.mesh().halfedge_slots(),
                      faces = edit.mesh().face_slots();
  const auto moved = [](auto element, std::uint32_t by) {
    return element ? decltype(element)(element.index + by) : element;
  };
  for (std::uint32_t i = 0; i < part.vertex_slots(); ++i) {
    const Vertex v = edit.add_vertex(part.position(Vertex(i)));
    edit.set_halfedge(v, moved(part.halfedge(Vertex(i)), halfedges));
  }
  for (std::uint32_t i = 0; i < part.edge_slots(); ++i) {
    const Halfedge h = halfedge(Edge(i));
    edit.add_edge(moved(part.from(h), vertices), moved(part.to(h), vertices));
  }
  for (std::uint32_t i = 0; i < part.halfedge_slots(); ++i) {
    const Halfedge h(i), added = moved(h, halfedges);
    edit.connect(added, moved(part.next(h), halfedges));
    edit.set_face(added, moved(part.face(h), faces));
  }
  for (std::uint32_t i = 0; i < part.face_slots(); ++i) edit.add_face(moved(part.halfedge(Face(i)), halfedges));
}

}  // namespace ryosen
