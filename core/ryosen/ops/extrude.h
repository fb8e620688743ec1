// Extrude: moves faces together and connects them to their old places by quads.
//
//                                d'------c'--e'
//                               /| f    / g /|
//        d-------c---e         a'------b'--h'|       every side at the border of the faces gets a wall down to its old
//       /  f    / g /     =>     | d- - -|- -|-e     place; the edge b-c between them moves along; the faces keep their
//      a-------b---h           |/      |   |/        numbers on top
//                              a-------b---h
//
// polygon list: the border are the edges with a named face and either another face that is not named or no second side;
//               a bridge is not of it. In the named faces every point that lies on the border, or that has another face
//               or a wire, is replaced by one new point, the same in all of them; their other points move. Each edge of
//               the border gets a quad (ci, cj, tj, ti), where ci-cj is the first side of a named face there and t are
//               the new points, in the order of the faces and sides. A face that is named twice counts once.
// needs: no face that is not named on the points of one that is.
// changes: with b edges of the border, V + b, E + 2b, F + b where each point that is replaced is on two of them. Else,
//          on points, V + p, E + b + q, F + b, with p points replaced, q of them on the border; where more than two
//          edges of the border meet, the faces touch themselves, and the edge up from there has as many walls.
// inverse: delete the walls and move the faces back; the points that were replaced, welded, are as before.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

// Said where an extrusion has no way.
inline constexpr std::string_view
    extruded_by_nothing_en =
        "Extruded by nothing: the new faces have no extent until something is moved or scaled; "
        "undo takes them away.",
    extruded_by_nothing_ja =
        "移動量ゼロで押し出しました。新しい面は、動かすか拡大縮小するまで広がりがありません。"
        "「元に戻す」で取り消せます。";

struct Extrude {
  std::vector<Face> faces;
  std::optional<double> distance = {};  // along their normal; default: the square root of their mean area
  std::optional<glm::dvec3> offset = {};

  static const OpInfo info;

  static Extrude at(const Mesh&, const OpTarget& target) { return {{target.face}}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const Extrude&) const = default;

  // The displacement of the faces: by default along the sum of their vector areas, those with a coordinate that is not
  // finite left out. Zero if that sum vanishes, as that of a closed surface does, or is not finite. O(corners).
  glm::dvec3 movement(const Mesh& mesh) const;
};

}  // namespace ryosen
