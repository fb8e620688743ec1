// Divides a face by an edge between two of its corners.
//
//        d-------c                d-------c
//        |       |                |  f' / |       f' left of a -> c is new
//        |   f   |       =>       |   /   |
//        |       |                | /  f  |
//        a-------b                a-------b
//
// on the list: (a, b, c, d) becomes (a, b, c) and the new face (a, c, d); the side that holds a ring in the view along
//              the old normal takes it, and the old face where that is undecided.
// needs: two corners of one loop of the face that no edge joins; both faces come apart into simple loops; no face is or
//        was on the same points as one of them.
// changes: E + 1, F + 1. Where left of a -> c lies the part with the outer loop, the other part is new.
// inverse: unite_loop.
#pragma once

#include "core/ops/op.h"

namespace ryosen {

struct SeparateLoop {
  Halfedge into_a, into_b;  // the sides of the face that arrive at the two corners

  static constexpr OpInfo info{"separate_loop",
                               "Divide face",
                               "ループ分割",
                               "A B [fN] [P-A] [Q-B]",
                               "divides a face by an edge from corner A to corner B",
                               "面を角 A と角 B を結ぶ稜線で分割する",
                               '\0',
                               OpTargetKind::selection,
                               "divide mef",
                               Topology::kept};

  static Parsed<SeparateLoop> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static SeparateLoop at(const Mesh& mesh, const OpTarget& target);
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
