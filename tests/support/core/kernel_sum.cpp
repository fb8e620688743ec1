#include "tests/support/core/kernel_sum.h"

#include <vector>

#include "ryosen/analysis/disjoint_sets.h"

namespace ryosen::test {

namespace {

std::int64_t count_cycles_outside(const Mesh& mesh) {
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

std::int64_t count_components(const Mesh& mesh) {
  DisjointSets sets(mesh.vertex_slots());
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    const Edge e(i);
    if (mesh.is_alive(e)) sets.join(mesh.from(halfedge(e, 0)).index, mesh.from(halfedge(e, 1)).index);
  }
  for (std::uint32_t i = 0; mesh.has_rings() && i < mesh.face_slots(); ++i)
    for (std::uint32_t r = mesh.first_ring(Face(i)); r != no_index; r = mesh.ring(r).next)
      sets.join(mesh.from(mesh.halfedge(Face(i))).index, mesh.from(mesh.ring(r).halfedge).index);
  return sets.count() - (mesh.vertex_slots() - mesh.live().vertices);
}

}  // namespace

KernelSum kernel_sum(const Mesh& mesh) {
  KernelSum sum;
  sum.vertices = mesh.live().vertices;
  sum.edges = mesh.live().edges;
  sum.faces = mesh.live().faces;
  sum.rings = mesh.live().rings;
  sum.boundaries = count_cycles_outside(mesh);
  sum.components = count_components(mesh);
  // Each component is a closed surface once its boundaries are capped, so the left side is even.
  sum.genus = sum.components - sum.left() / 2;
  return sum;
}

}  // namespace ryosen::test
