// Extrude: moves a face and connects it to its old boundary by quads.
//
//                                d'------c'
//                               /| f    /|
//        d-------c             a'------b'|        every side of the face gets a wall down to its old place; f keeps its
//       /  f    /     =>       | d- - -|-c        number on top
//      a-------b               |/      |/
//                              a-------b
//
// polygon list: f = (c0 .. cn-1) becomes (t0 .. tn-1), with a new quad (ci, cj, tj, ti) per side ci-cj that is no
//               bridge, in the order of the sides; rings get walls too, bridges move with f.
// needs: no second face on the same points.
// changes: V + n, E + 2n, F + n with n = corners of the face, those at bridges counted once.
// inverse: delete the walls and move f back.
#pragma once

#include "core/ops/op.h"

namespace ryosen {

struct Extrude {
  Face face;
  std::optional<double> distance = {};  // along the face's normal; default: the square root of its area
  std::optional<glm::dvec3> offset = {};

  static constexpr OpInfo info{"extrude",
                               "Extrude face",
                               "面の押し出し",
                               "fN [DISTANCE|X,Y,Z]",
                               "moves a face along its normal or by X,Y,Z and connects it to its old sides by walls",
                               "面を法線方向または X,Y,Z だけ動かし、元の位置と側面でつなぐ",
                               '\0',
                               OpTargetKind::face,
                               OpGroup::refine,
                               "",
                               Topology::kept};

  static Parsed<Extrude> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static Extrude at(const Mesh&, const OpTarget& target) { return {target.face}; }
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;

  // The displacement of the face. Zero if its area is zero or not finite. O(corners).
  glm::dvec3 movement(const Mesh& mesh) const;
};

}  // namespace ryosen
