#include "ryosen/mesh/columns.h"

#include <cstring>

namespace ryosen {

bool operator==(const MeshColumns& a, const MeshColumns& b) {
  const bool same_positions = a.positions.size() == b.positions.size() &&
                              (a.positions.empty() || std::memcmp(a.positions.data(), b.positions.data(),
                                                                  a.positions.size() * sizeof(glm::dvec3)) == 0);
  return same_positions && a.vertex_halfedge == b.vertex_halfedge && a.halfedges == b.halfedges &&
         a.face_halfedge == b.face_halfedge && a.next_copy == b.next_copy && a.copy_point == b.copy_point &&
         a.first_ring == b.first_ring && a.rings == b.rings && a.attributes == b.attributes && a.live == b.live &&
         a.file_vertices == b.file_vertices;
}

}  // namespace ryosen
