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

#include "ryosen/ops/lines/on_element.h"

namespace ryosen {

// See unite_series.h.
std::unique_ptr<OpSeries> unites_edges_in_series(Edit& edit);

struct UniteEdge : OnVertex<UniteEdge> {
  static constexpr OpInfo info{"unite_edge",
                               "Unite edges",
                               "稜線結合",
                               "vN",
                               "removes a vertex with exactly two edges and unites them",
                               "稜線がちょうど二本の頂点を取り除く",
                               '\0',
                               OpTargetKind::vertex,
                               OpGroup::euler,
                               "jekv",
                               Topology::kept,
                               Subject::edge,
                               OnSelection::each,
                               nullptr,
                               "",
                               unites_edges_in_series};

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
