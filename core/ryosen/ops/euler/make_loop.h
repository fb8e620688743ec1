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

#include "ryosen/ops/op.h"

namespace ryosen {

struct MakeLoop : OnHalfedge<MakeLoop> {
  static const OpInfo info;

  static MakeLoop at(const Mesh& mesh, const OpTarget& target);

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
