// Makes an edge without a face (a wire) between two vertices.
//
//        a   .   b                a---.---b        the corner at a is the gap that the edge enters, given by the
//        |       |       =>       |       |        boundary halfedge p -> a that ends there; likewise at b
//        p       q                p       q
//
// polygon list: a new wire pair.
// needs: two different points not joined by an edge, each isolated or with a gap.
// changes: E + 1, and B - 1, S - 1 if an end is isolated or the gaps are in two components; B + 1 if they are on one
//          cycle; B - 1, G + 1 if on two cycles of one component.
// inverse: delete_edge.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct MakeEdge {
  Vertex a, b;
  Halfedge into_a, into_b;  // none at an isolated vertex

  static const OpInfo info;

  static MakeEdge at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
  bool operator==(const MakeEdge&) const = default;
};

}  // namespace ryosen
