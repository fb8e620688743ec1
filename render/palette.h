// Colours and line styles by what they mean, in a dark and a light theme.
#pragma once

#include <cstdint>

#include "render/colour.h"
#include "render/overlay.h"

namespace ryosen {

enum class Theme { dark, light };

// What an element is drawn as.
enum class Role {
  hover,
  selected,
  legal,
  refused,
  witness,
  ghost,
  boundary,
  nonmanifold,
  misoriented,
  degenerate,
  duplicate,
  hanging,
  isolated,
  wire,
};
inline constexpr int role_count = 14;

// The looks of a role. Colours are safe for colour-blind people, and no two roles that can meet share both line style
// and point shape, so that colour is never the only sign.
struct Style {
  Rgba colour;
  LineStyle line;
  float width_px;
  PointShape point;
  float radius_px;
};
Style style(Role role, Theme theme);

// The bits of the byte that a face carries. Each has a tint and, but for `legal`, a pattern of its own.
struct FaceFlag {
  static constexpr std::uint8_t selected = 1;
  static constexpr std::uint8_t hovered = 2;
  static constexpr std::uint8_t legal = 4;
  static constexpr std::uint8_t refused = 8;
  static constexpr std::uint8_t duplicate = 16;
  static constexpr std::uint8_t degenerate = 32;
  static constexpr std::uint8_t misoriented = 64;
  static constexpr std::uint8_t hidden = 128;  // not drawn at all
};

// The colours of a theme that belong to no role.
struct Palette {
  Rgba background_top, background_bottom;
  Rgba front, back;     // the two sides of the surface
  Rgba key, fill, rim;  // light from the upper left, from the right, and at grazing angles
  Rgba wire;            // its alpha is the strength of the wireframe
  Rgba outline;         // around points, to set them off from any ground
};
const Palette& palette(Theme theme);

}  // namespace ryosen
