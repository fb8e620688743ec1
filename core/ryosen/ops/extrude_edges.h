// Extrude edges: moves copies of edges away and connects each to its edge by a quad.
//
//                                a'------b'------c'
//                                |       |       |
//        a-------b-------c       |       |       |      the points of the edges are copied once for all of them; a quad
//         \  f  / \  g  /   =>   a-------b-------c      runs against the face at its edge, so that the surface goes on
//          \   /   \   /          \  f  / \  g  /
//           \ /     \ /            \   /   \   /
//            d       e              d       e
//
// polygon list: each point that ends a named edge gets a new point t. Each named edge, once however it is named,
//               appends the quad (b, a, ta, tb), where a -> b is a side of a face there; a wire a - b appends (a, b,
//               tb, ta), and its pair is removed. An edge that may run either way, a wire or one with a face on both
//               sides, runs on from the other one where two alone meet; else as it is named, or along the face on its
//               left.
// needs: no bridge.
// changes: with e edges between p points, on points, V + p, E + e + p, F + e. B, S and G follow from the Euler-Poincare
//          formula: along open chains of a boundary, as it runs, all three stay.
// inverse: delete of the quads, if no edge was a wire.
#pragma once

#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

struct ExtrudeEdges {
  std::vector<Halfedge> edges;
  std::optional<double> distance = {};  // default: the mean length of the edges
  std::optional<glm::dvec3> offset = {};

  static const OpInfo info;

  static ExtrudeEdges at(const Mesh&, const OpTarget& target) { return {{target.halfedge}}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const ExtrudeEdges&) const = default;

  // The displacement of the copies: by default along the sum of the directions that lead out of the faces beside the
  // edges; where those cancel out, as around a hole, along the normal of the loop that the edges make. Zero if there is
  // none, as of a straight wire, or where it is not finite. O(edges and corners of the faces beside them).
  glm::dvec3 movement(const Mesh& mesh) const;
};

}  // namespace ryosen
