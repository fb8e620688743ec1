// Reverse: flips the orientation of a component.
//
//        +---->---->+           +<----<----+
//        | f  | g   |    =>     | f  | g   |
//        +<----<----+           +---->---->+
//
// polygon list: all faces connected to fN through shared edges are reversed; first corners stay.
// needs: a live face.
// changes: nothing on points. Wires and isolated vertices stay.
// inverse: itself.
#pragma once

#include "core/ops/lines/on_element.h"

namespace ryosen {

struct Reverse : OnFace<Reverse> {
  static constexpr OpInfo info{"reverse",
                               "Reverse component",
                               "成分の反転",
                               "fN",
                               "flips all faces of the component of fN",
                               "fN の連結成分の面をすべて裏返す",
                               '\0',
                               OpTargetKind::face};

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
