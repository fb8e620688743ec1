// Unites the two faces at an edge.
//
//        d-------c                d-------c
//        |  g  / |                |       |
//        |   /   |       =>       |   f   |       the lower number stays, with its material and groups
//        | /  f  |                |       |
//        a-------b                a-------b
//
// polygon list: the two lists are joined without the edge; rings are kept. At the ends of the edge the corner values of
//               the remaining face are kept.
// needs: two different faces that share this edge and touch nowhere else; no other face on the same points, before or
//        after.
// changes: E - 1, F - 1.
// inverse: separate_loop.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

class LocalFacts;

// See dissolve_series.h.
std::unique_ptr<OpSeries> unites_loops_in_series(Edit& edit);

struct UniteLoop : OnHalfedge<UniteLoop> {
  static const OpInfo info;

  Verdict check(const Mesh& mesh) const;
  // For many questions about one mesh.
  Verdict check(const Mesh& mesh, LocalFacts& known) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
