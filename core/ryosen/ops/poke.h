// Poke: replaces a face by a fan of triangles around a new vertex.
//
//        d-------c                d-------c
//        |       |                | \   / |
//        |   f   |       =>       |   m   |       (a, b, m) keeps the number f, the others get the next numbers in
//        |       |                | /   \ |       the order of the corners
//        a-------b                a-------b
//
// polygon list: (c0 .. cn-1) becomes (c0, c1, m), (c1, c2, m), .., (cn-1, c0, m).
// needs: a face without rings and bridges and without a second face on the same points.
// changes: V + 1, E + n, F + n - 1.
// inverse: dissolve m.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

// See EqualFaceIndex (rules/face_lists.h).
std::unique_ptr<OpSeries> pokes_in_series(Edit& edit);

struct Poke {
  Face face;
  std::optional<glm::dvec3> target = {};  // position of m; default: the mean of the corners

  static const OpInfo info;

  static Poke at(const Mesh&, const OpTarget& target) { return {target.face}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const Poke&) const = default;

  // The position of m; the mean is taken over the finite corners. O(corners).
  glm::dvec3 position(const Mesh& mesh) const;
};

// Divides any face without rings and bridges, also one with another on the same points.
OpEffect poke(Edit& edit, Face face, const glm::dvec3& place);

}  // namespace ryosen
