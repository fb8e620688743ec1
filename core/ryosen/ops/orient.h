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
  static const OpInfo info;

  static Orient at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
  bool operator==(const Orient&) const = default;
};

// By face slot whether the operator turns it.
std::vector<bool> turned_by_orient(const Mesh& mesh);

}  // namespace ryosen
