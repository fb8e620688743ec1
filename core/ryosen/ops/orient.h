// Orient: flips faces so that neighbours are consistently oriented where possible.
//
//     +---->+---->+          +---->+<----+
//     | f   | g   |    =>    | f   | g   |        f and g ran their common edge in the same direction; now they do not
//     +<----+<----+          +<----+---->+
//
// polygon list: some faces are reversed (the first corner stays); in each component the smaller set of faces is
//               flipped, on a tie the one without the lowest face; faces without area count where there are no others.
//               Neighbours are the two faces of an edge with exactly two. A non-orientable component (a Moebius strip)
//               keeps a seam of misoriented edges. There patches (faces connected through consistent neighbours) and
//               single faces are flipped while the seam gets shorter: once starting from the current orientation, once
//               from a breadth-first orientation from the lowest face; the shorter result is taken if it beats the
//               current seam, otherwise the component is unchanged.
// needs: neighbours disagree that could agree, or a seam can be shortened.
// changes: V, E and B of the stored mesh decrease as cut edges close; on points only the number of misoriented edges
//          decreases, to zero on each orientable component.
// inverse: undo only.
#pragma once

#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

struct Orient {
  static constexpr OpInfo info{"orient",
                               "Orient faces",
                               "面の向きを揃える",
                               "",
                               "flips faces so that neighbours are consistently oriented where possible",
                               "隣り合う面の向きの不一致が減るように、可能ならなくなるように面を裏返す",
                               'O',
                               OpTargetKind::none,
                               OpGroup::orient,
                               "",
                               Topology::may_change,
                               Subject::edge,
                               OnSelection::none};

  static Parsed<Orient> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static Orient at(const Mesh&, const OpTarget&) { return {}; }
  std::string command(const Mesh&) const { return "orient"; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
};

// By face slot whether the operator turns it.
std::vector<bool> turned_by_orient(const Mesh& mesh);

}  // namespace ryosen
