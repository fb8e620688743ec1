// Separate fans: a vertex with several fans of faces becomes one vertex per fan.
//
//        a     c               a     c
//        | ' f |               | ' f |
//           v          =>         v           two copies of one point: figures, names and files do not change
//        | ' g |                  v'
//        b     d               | ' g |
//                              b     d
//
// polygon list: each fan except the one with the lowest face gets a new copy of the point; wires stay with the first.
// needs: a vertex with several fans.
// changes: V + fans - 1 stored vertices, nothing on points; B and S as the boundary cycles split.
// inverse: weld of the copies. To make them separate points: detach.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct SeparateFans : OnVertex<SeparateFans> {
  static const OpInfo info;

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
