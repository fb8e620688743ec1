// How something asks to be drawn, as plain data: what draws reads it.
#pragma once

#include <cstdint>

namespace ryosen {

enum class LineStyle { solid, dashed, dash_dot, dotted };
enum class PointShape { disc, ring, cross, diamond, square };
// The pattern of a tinted face: a sign other than its colour.
// `bars` are told from any colour: they have dark edges, and the face is seen between them.
enum class FacePattern { plain, diagonal, chessboard, horizontal, bars };

// Colours are 0xRRGGBB.
struct Looks {
  std::uint32_t dark, light;  // the colour in the dark and in the light theme
  LineStyle line;
  float width_px;
  PointShape point;
  float radius_px;
};

// A face in the colour of its looks.
struct FaceTint {
  FacePattern pattern;
  float strength;  // from 0, nothing of it, to 1, nothing of the face
  friend constexpr bool operator==(const FaceTint&, const FaceTint&) = default;
};

}  // namespace ryosen
