// Make face: a new face on three or more vertices.
//
//        d     c                d-----c
//              |                |  f  |       sides that exist must be free on their left, others are made
//              |       =>       |     |
//        a-----b                a-----b
//
// on the list: the face (A, B, C, ...) is put behind the others. A pair that is one of its sides is none any more.
// needs: no point twice; no face on the same points; along each side A -> B no face yet, and at most one that runs B -> A;
//        a corner between two new sides is isolated or has a gap.
// changes: F + 1, E + the sides that are new; V unless copies become one. B, S and G follow from the sum: on a cycle of
//          existing edges B - 1.
// inverse: delete of the face, where no side was a wire and no corner isolated.
#pragma once

#include <vector>

#include "core/ops/op.h"

namespace ryosen {

struct MakeFace {
  std::vector<Vertex> corners;

  static constexpr OpInfo info{"make_face",
                               "Make face",
                               "面生成",
                               "A B C ...",
                               "makes a face on three or more vertices, counter-clockwise",
                               "三つ以上の頂点に反時計回りに面を張る",
                               '\0',
                               OpTargetKind::selection};

  static Parsed<MakeFace> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static MakeFace at(const Mesh& mesh, const OpTarget& target);
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
