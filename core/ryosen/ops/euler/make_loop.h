// Makes a face on a boundary cycle of edges.
//
//        d-----c                d-----c
//        |     |                |  f  |       the face is left of a -> b
//        |     |       =>       |     |
//        a---->b                a---->b
//
// polygon list: the cycle becomes a face; bridges in it are traversed in both directions. A wire that gets a face is no
//               longer a pair.
// needs: a boundary halfedge; without its bridges the cycle splits into simple loops of three or more corners that
//        share no point; no face on the same points; sheets between the same points stay as reading would make them.
// changes: F + 1, B - 1.
// inverse: delete_loop.
#pragma once

#include "ryosen/ops/lines/on_element.h"

namespace ryosen {

struct MakeLoop : OnHalfedge<MakeLoop> {
  static constexpr OpInfo info{"make_loop",
                               "Make loop",
                               "ループ生成",
                               "A-B",
                               "puts a face into the outside cycle left of A-B",
                               "半稜線 A-B の左の外側の閉路に面を張る",
                               '\0',
                               OpTargetKind::edge,
                               OpGroup::euler,
                               "mf",
                               Topology::may_change,
                               Subject::cycle};

  static MakeLoop at(const Mesh& mesh, const OpTarget& target);

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
