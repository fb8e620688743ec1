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

#include "ryosen/ops/lines/on_element.h"

namespace ryosen {

struct SeparateFans : OnVertex<SeparateFans> {
  static constexpr OpInfo info{"separate_fans",
                               "Separate fans",
                               "扇の分離",
                               "vN",
                               "gives each fan of faces at a vertex a copy of its own",
                               "頂点の面の扇ごとに複製の頂点を作る",
                               '\0',
                               OpTargetKind::vertex,
                               OpGroup::join};

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
