// Split: inserts a vertex on an edge and cuts the triangles at it.
//
//        c                     c
//       / \                   /|\                                                          .
//      /   \                 / | \                                                         .
//     a --> b       =>      a--m--b        each side for itself: a triangle is cut in two, another face gets a corner
//      \   /                 \ | /
//       \ /                   \|/
//        d                     d
//
// polygon list: every face with the side a-b gets m there; a triangle (a, b, c) becomes (a, m, c) and (m, b, c). The
//               part with A keeps the old number; new faces are numbered starting with the one left of A-B.
// needs: the triangles to be cut have different third points; the edge is no bridge.
// changes: V + 1, E + 1 + k, F + k with k = triangles at the edge, counted on points. A non-manifold or misoriented
//          edge is split in all its faces at once, and the new point has one copy per face. At a place off the edge
//          values are blended as at the edge's nearest point.
// inverse: collapse m-b end.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "ryosen/ops/op.h"

namespace ryosen {

struct SplitEdge {
  Halfedge halfedge;
  double along = 0.5;                    // position A + along (B - A)
  std::optional<glm::dvec3> place = {};  // instead; finite

  static const OpInfo info;

  static SplitEdge at(const Mesh&, const OpTarget& target) { return {target.halfedge, target.snapped_along()}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const SplitEdge&) const = default;

  // Where the new vertex comes, and the share of the way along the edge by which values are blended. O(1).
  glm::dvec3 position(const Mesh& mesh) const;
  double blend(const Mesh& mesh) const;
};

}  // namespace ryosen
