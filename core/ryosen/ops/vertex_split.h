// Vertex split: replaces a vertex by the two ends of a new edge.
//
//        L                     L
//        |                    / \                                                          .
//     f  |  e                /   \                                                         .
//    ----v----      =>    --v-----m--      m takes what lies from L counter-clockwise to R; the edges v-L and v-R
//     g  |  h                \   /         become the triangles at v-m. (The drawing looks from below: L to R runs
//        |                    \ /          through e and h there.)
//        R                     R
//
// polygon list: v is replaced by m in the faces and wires from the edge v-L counter-clockwise to v-R (the sector);
//               (v, L, m) and (v, m, R) are new. With `-` for L or R the sector starts or ends at the adjacent gap of
//               v, and there is no triangle on that side.
// needs: L and R are different neighbours of v in one fan of faces, by edges with a face; if v has further fans the
//        sector contains no gap; no edge that moves to m is cut, nor one that gets an additional face; no face at m
//        duplicates another.
// changes: V + 1, E + 3, F + 2, with `-` V + 1, E + 2, F + 1; H, S, G, B stay.
// inverse: collapse m-v. Source: [Hoppe96].
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct VertexSplit {
  Vertex vertex;
  Halfedge left, right;  // v -> L and v -> R; none for `-`
  std::optional<glm::dvec3> target = {};

  static const OpInfo info;

  static VertexSplit at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const VertexSplit&) const = default;

  // The position of m. Without a target: halfway to the mean of its future neighbours or, if that inverts a face,
  // halfway away from the mean of those that v keeps, then a quarter and an eighth of the way on either line; the first
  // position that inverts nothing, else halfway. O(corners at v).
  glm::dvec3 position(const Mesh& mesh) const;
};

}  // namespace ryosen
