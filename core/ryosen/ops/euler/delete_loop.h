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

#include "ryosen/ops/lines/on_element.h"

namespace ryosen {

struct DeleteLoop : OnFace<DeleteLoop> {
  static constexpr OpInfo info{"delete_loop",
                               "Delete loop",
                               "ループ消去",
                               "fN",
                               "deletes a face but keeps its edges",
                               "面だけを取り除き、稜線は残す",
                               '\0',
                               OpTargetKind::face,
                               OpGroup::euler,
                               "kf"};

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
