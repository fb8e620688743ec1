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

#include "ryosen/ops/lines/on_element.h"

namespace ryosen {

struct DeleteEdge : OnHalfedge<DeleteEdge> {
  static constexpr OpInfo info{"delete_edge",
                               "Delete edge",
                               "稜線消去",
                               "A-B",
                               "takes away an edge that has no face",
                               "面を持たない稜線を取り除く",
                               '\0',
                               OpTargetKind::edge,
                               OpGroup::euler};

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
