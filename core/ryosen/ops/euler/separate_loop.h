// Divides a face by an edge between two of its corners.
//
//        d-------c                d-------c
//        |       |                |  f' / |       f' left of a -> c is new
//        |   f   |       =>       |   /   |
//        |       |                | /  f  |
//        a-------b                a-------b
//
// polygon list: (a, b, c, d) becomes (a, b, c) and the new face (a, c, d); a ring goes to the part that contains it in
//               the projection along the old normal, or stays with the old face if that is undecided.
// needs: two corners of one loop of the face, not joined by an edge; both faces split into simple loops; no other face
//        on the same points, before or after.
// changes: E + 1, F + 1. If the outer loop is to the left of a -> c, the other part is the new face.
// inverse: unite_loop.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct SeparateLoop {
  Halfedge into_a, into_b;  // the sides of the face that end at the two corners

  static const OpInfo info;

  static SeparateLoop at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const SeparateLoop&) const = default;
};

}  // namespace ryosen
