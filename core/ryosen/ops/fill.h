// Fill: makes one face on a hole.
//
//        d-----c                d-----c
//        |     |                |  f  |       the face is left of the boundary halfedge a -> b
//        |     |       =>       |     |
//        a---->b                a---->b
//
// polygon list: the boundary cycle through a -> b becomes a face.
// needs: a boundary halfedge, on a cycle of three or more edges without a repeated point; no face on the same points;
//        no edge of the cycle has two faces on points. (make_loop also accepts cycles with bridges.)
// changes: F + 1, B - 1.
// inverse: delete_loop; delete if no edge was a wire.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct Fill : OnHalfedge<Fill> {
  static const OpInfo info;

  // A boundary edge belongs to one hole, in whichever direction it is named.
  static Fill of_edge(const Mesh& mesh, Halfedge h);
  static Fill at(const Mesh& mesh, const OpTarget& target);

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
