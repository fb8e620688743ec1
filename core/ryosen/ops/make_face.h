// Make face: makes a face on three or more vertices.
//
//        d     c                d-----c
//              |                |  f  |       sides that exist must be free on their left, others are made
//              |       =>       |     |
//        a-----b                a-----b
//
// polygon list: the face (A, B, C, ...) is appended. A wire pair that is one of its sides is removed.
// needs: no point twice; no face on the same points; no face along any side A -> B, and at most one along B -> A; a
//        corner between two new sides is isolated or has a gap.
// changes: F + 1, E + the new sides; V stays unless copies are merged. B, S and G follow from the Euler-Poincare
//          formula: on a cycle of existing edges B - 1.
// inverse: delete of the face, if no side was a wire and no corner isolated.
#pragma once

#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

class Sheets;

struct MakeFace {
  std::vector<Vertex> corners;

  static const OpInfo info;

  static MakeFace at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const MakeFace&) const = default;
};

// The face on these corners, as make_face allows it: on free sides where there are any, on new edges elsewhere. Its
// points are to be made manifold then. Cost: the fans at its corners.
Face attach_face(Edit& edit, Sheets& sheets, std::span<const Vertex> corners);

}  // namespace ryosen
