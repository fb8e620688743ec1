// Deletes an edge without a face (a wire); its ends stay.
//
//        a---.---b                a   .   b
//        |       |       =>       |       |
//
// polygon list: the wire's pair is removed.
// needs: an edge without a face on either side.
// changes: E - 1, and B - 1 if its sides are on two cycles; else B + 1, and S + 1 if the ends become disconnected, G -
//          1 if not.
// inverse: make_edge.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct DeleteEdge : OnHalfedge<DeleteEdge> {
  static const OpInfo info;

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
