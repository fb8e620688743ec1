// Removes a bridge, so that the inner loop becomes a ring of its face.
//
//        o---------o                o---------o
//        |  o---o  |                |  o---o  |
//        |  |   |  |       =>       |  |   |  |
//        |  o---o  |                |  o---o  |
//        | /       |                |         |
//        o---------o                o---------o
//
// polygon list: the corner list splits into two loops.
// needs: an edge with the same face on both sides, between loops of three or more corners.
// changes: E - 1, H + 1. The loop with the larger projected area is the outer one, on a tie the one with the smaller
//          vertex.
// inverse: unite_ring.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct MakeRing : OnHalfedge<MakeRing> {
  static const OpInfo info;

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
