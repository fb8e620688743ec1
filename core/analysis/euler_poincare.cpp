#include "core/analysis/euler_poincare.h"

#include <vector>

#include "core/analysis/components.h"

namespace ryosen {

namespace {

std::int64_t count_boundaries(const Mesh& mesh) {
  std::int64_t count = 0;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    count += mesh.is_alive(Vertex(i)) && mesh.is_isolated(Vertex(i));
  std::vector<bool> seen(mesh.halfedge_slots(), false);
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge start(i);
    if (!mesh.is_alive(start) || !mesh.is_outside(start) || seen[i]) continue;
    ++count;
    for (Halfedge h = start; !seen[h.index]; h = mesh.next(h)) seen[h.index] = true;
  }
  return count;
}

}  // namespace

EulerPoincare euler_poincare(const Mesh& mesh) {
  EulerPoincare e;
  e.vertices = mesh.live().vertices;
  e.edges = mesh.live().edges;
  e.faces = mesh.live().faces;
  e.rings = mesh.live().rings;
  e.boundaries = count_boundaries(mesh);
  e.components = count_kernel_components(mesh);
  // Each component is a closed surface once its boundaries are capped, so the left side is even.
  e.genus = e.components - e.left() / 2;
  return e;
}

}  // namespace ryosen
