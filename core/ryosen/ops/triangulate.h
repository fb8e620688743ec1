// Triangulate: cuts a face, or every face, into triangles.
//
//        d-------c                d-------c
//        |       |                |  f' / |       the triangle at the face's first side keeps the number,
//        |   f   |       =>       |   /   |       the others get the next ones
//        |       |                | /  f  |
//        a-------b                a-------b
//
// polygon list: a face of n corners and h rings becomes n + 2h - 2 triangles on its corners: the drawn ones if no new
//               side is already an edge, else others (face_triangles.h).
// needs: a face of more than three corners without a duplicate, and a triangulation that creates no existing edge.
// changes: E + n + 3h - 3, F + n + 2h - 3, H - h; V stays. Without a face: every face for which this is legal, in
//          ascending order; the others are unchanged.
// inverse: dissolve the new edges.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

// See EqualFaceIndex (rules/face_lists.h).
std::unique_ptr<OpSeries> triangulations_in_series(Edit& edit);

struct Triangulate {
  Face face;  // none: all faces

  static const OpInfo info;

  static Triangulate at(const Mesh&, const OpTarget& target) { return {target.face}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const Triangulate&) const = default;
};

}  // namespace ryosen
