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

  static constexpr OpInfo info{"separate_loop",
                               "Divide face",
                               "ループ分割",
                               "A B [fN] [P-A] [Q-B]",
                               "divides a face by an edge from corner A to corner B",
                               "面を角 A と角 B を結ぶ稜線で分割する",
                               '\0',
                               OpTargetKind::selection,
                               OpGroup::euler,
                               "divide mef",
                               Topology::kept,
                               Subject::edge,
                               OnSelection::all};

  static Parsed<SeparateLoop> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static SeparateLoop at(const Mesh&, const OpTarget&) { return {}; }
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
