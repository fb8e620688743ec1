#include "ryosen/ops/rules/corner_values.h"

#include <algorithm>

namespace ryosen {

void drop_normal(Edit& edit, Halfedge corner) {
  const int normal = edit.mesh().find_attribute(attribute_names::normal);
  if (normal < 0) return;
  const auto k = static_cast<std::size_t>(normal);
  edit.set_attribute(k, corner.index, edit.mesh().attributes()[k].fill);
}

bool is_seam(const Mesh& mesh, Halfedge h) {
  return !mesh.is_outside(h) && !mesh.is_outside(twin(h)) && corner_values_differ(mesh, h, twin(h), false);
}

// Merges the corner `first`, the ones across the removed edges in sequence, and `last`, whose edge stays.
void merge_corner_values(Edit& edit, std::span<const Edge> edges_that_go, const NumberOfFace& number) {
  const Mesh& m = edit.mesh();
  const auto goes = [&](Halfedge h) { return std::binary_search(edges_that_go.begin(), edges_that_go.end(), edge(h)); };
  if (!has_attributes(m, ElementKind::corner)) return;
  for (Edge e : edges_that_go)
    for (Halfedge first : {halfedge(e), twin(halfedge(e))}) {
      if (goes(m.prev(first))) continue;
      Halfedge kept = first, last = first;
      while (goes(last)) {
        last = m.next(twin(last));
        if (number(m.face(last)) <= number(m.face(kept))) kept = last;
      }
      if (kept != last) edit.derive(last, kept, Derivation::copies);
    }
}

}  // namespace ryosen
