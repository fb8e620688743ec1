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

  static constexpr OpInfo info{"reverse",
                               "Reverse component",
                               "成分の反転",
                               "fN [fM ...]",
                               "flips all faces of the components of the named faces",
                               "指定した面の連結成分の面をすべて裏返す",
                               '\0',
                               OpTargetKind::face,
                               OpGroup::orient,
                               "",
                               Topology::may_change,
                               Subject::edge,
                               OnSelection::all};

  static Parsed<Reverse> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static Reverse at(const Mesh&, const OpTarget& target) { return {{target.face}}; }
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
