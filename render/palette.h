// Colours and line styles by what they mean, in a dark and a light theme.
#pragma once

#include <array>
#include <cstdint>

#include "render/colour.h"
#include "render/overlay.h"
#include "ryosen/scene/view/view_settings.h"

namespace ryosen {

// What an element is drawn as because of the pointer or the selection; highlights bring their own looks.
enum class Role {
  hover,
  selected,
  legal,
  refused,
  witness,
  ghost,
  goes,  // what an operator takes away
};

// The looks of a role or a highlight in a theme. Colours are safe for colour-blind people, and no two that can meet
// share both line style and point shape, so that colour is never the only sign.
struct Style {
  Rgba colour;
  LineStyle line;
  float width_px;
  PointShape point;
  float radius_px;
};
Style style(Role role, Theme theme);
Style style(const Looks& looks, Theme theme);

// The colours of a theme that belong to no role.
struct Palette {
  Rgba background_top, background_bottom;
  Rgba front, back;     // the two sides of the surface
  Rgba key, fill, rim;  // light from the upper left, from the right, and at grazing angles
  Rgba wire;            // its alpha is the strength of the wireframe
  // What each layer of a surface that is seen through adds to a dark ground, or takes from a light one, and what its
  // wireframe does.
  Rgba film, film_wire;
  Rgba label, label_ground;  // text in the picture, and what lies below it
  Rgba outline;              // around points, to set them off from any ground
  Rgba cut;                  // where the surface is cut
  Rgba grid;                 // on the ground; its alpha is that of every tenth line
  std::array<Rgba, 3> axes;  // X, Y, Z, which always come with their letters
};
const Palette& palette(Theme theme);

}  // namespace ryosen
