#include "ryosen/analysis/one_ring_sums.h"

#include <algorithm>
#include <cassert>

#include "ryosen/mesh/prefetch.h"

namespace ryosen {

void one_ring_sums(const Mesh& mesh, std::span<const glm::dvec3> values, std::span<glm::dvec3> sums) {
  assert(values.size() == mesh.vertex_slots() && sums.size() == mesh.vertex_slots());
  std::fill(sums.begin(), sums.end(), glm::dvec3(0));
  // Edges are sorted by one end (pair_corners), which is in the cache; prefetch the other.
  constexpr std::uint32_t ahead = 32;
  const std::uint32_t edges = mesh.edge_slots();
  for (std::uint32_t e = 0; e < edges; ++e) {
    if (e + ahead < edges) {
      const Vertex far = mesh.to(halfedge(Edge(e + ahead)));
      prefetch_cell(values.data(), far.index);
      prefetch_cell(sums.data(), far.index);
    }
    if (!mesh.is_alive(Edge(e))) continue;
    const Vertex a = mesh.from(halfedge(Edge(e))), b = mesh.to(halfedge(Edge(e)));
    sums[a.index] += values[b.index];
    sums[b.index] += values[a.index];
  }
}

}  // namespace ryosen
