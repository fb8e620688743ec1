// Deletes a face; its edges stay, as wires if they have no other face.
//
//        d-----c                d-----c
//        |  f  |                |     |
//        |     |       =>       |     |
//        a-----b                a-----b
//
// polygon list: the face is removed; sides without another face become wire pairs.
// needs: a live face.
// changes: F - 1, H - r, B + 1 + r for a face with r rings, and per ring S + 1 or G - 1.
// inverse: make_loop, for a face without rings.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct DeleteLoop : OnFace<DeleteLoop> {
  static const OpInfo info;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
