// Removes a vertex with exactly two edges and unites them.
//
//             a-----m-----b       =>       a-----------b
//
// polygon list: m is removed from every face and wire pair.
// needs: a vertex without copies and with exactly two edges, whose other ends are not joined; faces keep three corners;
//        no other face is on their remaining points.
// changes: V - 1, E - 1.
// inverse: separate_edge.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

// See unite_series.h.
std::unique_ptr<OpSeries> unites_edges_in_series(Edit& edit);

struct UniteEdge : OnVertex<UniteEdge> {
  static const OpInfo info;

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
