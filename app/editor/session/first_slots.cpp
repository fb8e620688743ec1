#include "app/editor/session/first_slots.h"

namespace ryosen {

std::vector<Element> FirstSlots::added_to(const Mesh& mesh) const {
  std::vector<Element> added;
  for (Face f(faces_); f.index < mesh.face_slots(); ++f.index)
    if (mesh.is_alive(f)) added.push_back(f);
  for (Edge e(edges_); e.index < mesh.edge_slots(); ++e.index)
    if (mesh.is_alive(e) && mesh.is_wire(e)) added.push_back(e);
  for (Vertex v(vertices_); v.index < mesh.vertex_slots(); ++v.index)
    if (mesh.is_alive(v) && mesh.is_isolated(v)) added.push_back(v);
  return added;
}

}  // namespace ryosen
