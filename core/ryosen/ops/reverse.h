// Reverse: flips the orientation of components.
//
//        +---->---->+           +<----<----+
//        | f  | g   |    =>     | f  | g   |
//        +<----<----+           +---->---->+
//
// polygon list: all faces connected to a named one through shared edges are reversed once; first corners stay.
// needs: live faces.
// changes: nothing on points. Wires and isolated vertices stay.
// inverse: itself.
#pragma once

#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

struct Reverse {
  std::vector<Face> faces;

  static const OpInfo info;

  static Reverse at(const Mesh&, const OpTarget& target) { return {{target.face}}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
  bool operator==(const Reverse&) const = default;
};

}  // namespace ryosen
