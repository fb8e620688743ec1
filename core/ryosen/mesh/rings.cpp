#include "ryosen/mesh/rings.h"

#include <algorithm>
#include <utility>

namespace ryosen {

std::uint32_t ring_of(const Mesh& mesh, Halfedge h) {
  const Face f = mesh.face(h);
  std::vector<std::pair<Halfedge, std::uint32_t>> starts;
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next)
    starts.emplace_back(mesh.ring(r).halfedge, r);
  if (starts.empty()) return no_index;
  std::sort(starts.begin(), starts.end());
  for (Halfedge g : loop(mesh, h)) {
    const auto place = std::lower_bound(starts.begin(), starts.end(), std::pair(g, std::uint32_t{0}));
    if (place != starts.end() && place->first == g) return place->second;
  }
  return no_index;
}

bool replace_start(Edit& edit, Face f, Halfedge old, Halfedge start) {
  const Mesh& mesh = edit.mesh();
  if (mesh.halfedge(f) == old) {
    edit.set_halfedge(f, start);
    return true;
  }
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next) {
    if (mesh.ring(r).halfedge != old) continue;
    edit.set_ring_halfedge(r, start);
    return true;
  }
  return false;
}

void move_rings(Edit& edit, Face from, Face to) {
  const Mesh& mesh = edit.mesh();
  while (mesh.has_rings(from)) {
    const std::uint32_t ring = mesh.first_ring(from);
    const Halfedge start = mesh.ring(ring).halfedge;
    edit.remove_ring(from, ring);
    edit.add_ring(to, start);
  }
}

}  // namespace ryosen
