// Orient: turns faces so that all neighbours agree where they can.
//
//     +---->+---->+          +---->+<----+
//     | f   | g   |    =>    | f   | g   |        f and g ran their common edge in the same direction; now they do not
//     +<----+<----+          +<----+---->+
//
// on the list: some faces run the other way round (the first corner stays); in each component the side with fewer faces
//              turns, with equal numbers the one without the lowest face. Neighbours are two faces alone on an edge. A
//              component that cannot be oriented (a Moebius strip) keeps a seam of misoriented edges. There patches, the
//              faces joined by neighbours that agree, and single faces turn while the seam gets shorter: from the faces
//              as they are, and from a walk from the lowest face over its neighbours; the shorter result is taken if it
//              is shorter than the seam that there was, and the component stays as it is otherwise.
// needs: some two neighbours disagree although they could agree, or a seam gets shorter.
// changes: V, E and B of the kernel fall as cut edges close; on points only the number of misoriented edges, which falls:
//          to none on each component that can be oriented.
// inverse: none of its own; undo.
#pragma once

#include "core/ops/op.h"

namespace ryosen {

struct Orient {
  static constexpr OpInfo info{"orient",
                               "Orient faces",
                               "面の向きを揃える",
                               "",
                               "turns faces so that fewer neighbours disagree, none where possible",
                               "隣り合う面の向きの不一致が減るように、可能ならなくなるように面を裏返す",
                               'O',
                               OpTargetKind::none};

  static Parsed<Orient> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static Orient at(const Mesh&, const OpTarget&) { return {}; }
  std::string command(const Mesh&) const { return "orient"; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
