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

// See rules/equal_face_index.h.
std::unique_ptr<OpSeries> pokes_in_series(Edit& edit);

struct Poke {
  Face face;
  std::optional<glm::dvec3> target = {};  // position of m; default: the mean of the corners

  static constexpr OpInfo info{"poke",
                               "Poke face",
                               "面の放射分割",
                               "fN [X,Y,Z]",
                               "puts a vertex into the face and joins it to all corners",
                               "面の中に頂点を置き、すべての角と結ぶ",
                               '\0',
                               OpTargetKind::face,
                               OpGroup::refine,
                               "",
                               Topology::kept,
                               Subject::edge,
                               OnSelection::each,
                               nullptr,
                               "",
                               pokes_in_series};

  static Parsed<Poke> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static Poke at(const Mesh&, const OpTarget& target) { return {target.face}; }
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;

  // The position of m; the mean is taken over the finite corners. O(corners).
  glm::dvec3 position(const Mesh& mesh) const;
};

// Divides any face without rings and bridges, also one with another on the same points.
OpEffect poke(Edit& edit, Face face, const glm::dvec3& place);

}  // namespace ryosen
