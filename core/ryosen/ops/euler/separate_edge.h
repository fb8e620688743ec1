// Inserts a vertex into an edge, without cutting faces.
//
//             a-----------b       =>       a-----m-----b
//
// polygon list: every face and wire pair at the edge gets a corner, triangles too.
// needs: an edge that is no bridge.
// changes: V + 1, E + 1. All sheets of a non-manifold or misoriented edge are divided; the point has a copy on each.
// inverse: unite_edge.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct SeparateEdge {
  Halfedge halfedge;
  double along = 0.5;

  static const OpInfo info;

  static SeparateEdge at(const Mesh&, const OpTarget& target) { return {target.halfedge, target.snapped_along()}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const SeparateEdge&) const = default;
};

}  // namespace ryosen
