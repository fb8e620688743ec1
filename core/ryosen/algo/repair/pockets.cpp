#include "ryosen/algo/repair/pockets.h"

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// The face on the other side of the pocket that begins with this face, or none. `across` tells the side beyond a side.
template <class Across>
Face beyond_pocket(const Mesh& m, Face f, Across across) {
  Face beyond;
  for (const Halfedge h : halfedges_around(m, f)) {
    const Halfedge other = across(h);
    if (!other || m.is_outside(other)) return Face();
    const Face g = m.face(other);
    if ((beyond && g != beyond) || g <= f) return Face();
    if (m.position(m.from(h)) != m.position(m.to(other)) || m.position(m.to(h)) != m.position(m.from(other)))
      return Face();
    beyond = g;
  }
  return beyond;
}

template <class Across>
std::vector<std::pair<Face, Face>> pockets_by(const Mesh& m, Across across) {
  std::vector<std::pair<Face, Face>> found;
  for (const Face f : live_faces(m)) {
    const Face g = beyond_pocket(m, f, across);
    if (g && corner_count(m, f) == corner_count(m, g)) found.emplace_back(f, g);
  }
  return found;
}

}  // namespace

std::vector<std::pair<Face, Face>> find_pockets(const Mesh& mesh, const std::vector<Halfedge>& across) {
  return pockets_by(mesh, [&](Halfedge h) { return across[h.index]; });
}

std::vector<std::pair<Face, Face>> pockets_of(const Mesh& mesh) {
  return pockets_by(mesh, [](Halfedge h) { return twin(h); });
}

}  // namespace ryosen
