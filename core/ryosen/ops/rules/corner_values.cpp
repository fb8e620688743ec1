#include "ryosen/ops/rules/corner_values.h"

#include <algorithm>

namespace ryosen {

std::uint32_t CornerWriter::index(std::size_t attribute, Halfedge corner) const {
  return edit_.mesh().attributes()[attributes_[attribute].index_column].data[corner.index];
}

void CornerWriter::set(std::size_t attribute, Halfedge corner, std::uint32_t index) {
  edit_.set_attribute(attributes_[attribute].index_column, corner.index, std::span(&index, 1));
}

std::uint32_t CornerWriter::blend(std::size_t attribute, std::uint32_t a, std::uint32_t b, double t) {
  const std::uint32_t ends[] = {a, b};
  const double weights[] = {1 - t, t};
  return edit_.derive_in_pool(attributes_[attribute].pool_column, ends, weights);
}

bool is_seam(const Mesh& mesh, Halfedge h) {
  return !mesh.is_outside(h) && !mesh.is_outside(twin(h)) && corner_values_differ(mesh, h, twin(h), false);
}

// Merges the corner `first`, the ones across the removed edges in sequence, and `last`, whose edge stays.
void merge_corner_values(Edit& edit, std::span<const Edge> edges_that_go, const NumberOfFace& number) {
  const Mesh& m = edit.mesh();
  const auto goes = [&](Halfedge h) { return std::binary_search(edges_that_go.begin(), edges_that_go.end(), edge(h)); };
  CornerWriter corners(edit);
  if (corners.count() == 0) return;
  for (Edge e : edges_that_go)
    for (Halfedge first : {halfedge(e), twin(halfedge(e))}) {
      if (goes(m.prev(first))) continue;
      Halfedge kept = first, last = first;
      while (goes(last)) {
        last = m.next(twin(last));
        if (number(m.face(last)) <= number(m.face(kept))) kept = last;
      }
      for (std::size_t k = 0; k < corners.count() && kept != last; ++k) corners.set(k, last, corners.index(k, kept));
    }
}

}  // namespace ryosen
