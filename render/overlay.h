// Overlay primitives drawn over the surface: lines, points and ghost triangles, as plain data.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "render/colour.h"
#include "ryosen/scene/highlights/looks.h"

namespace ryosen {

// Opacity of an element where the surface occludes it: 0 invisible, 1 as if in front.
inline constexpr float faintly = 0.22f;

struct Line {
  glm::dvec3 a{0};
  glm::dvec3 b{0};
  Rgba colour{};
  LineStyle style = LineStyle::solid;
  float width_px = 2;
  float hidden = faintly;
  bool arrow = false;      // with an arrow head at b
  bool thins_out = false;  // a third as wide as it is long on the screen, down to a pixel: of many that lie dense
  bool is_rim = false;     // a pixel larger on all sides, the head too: what is drawn below such a line as its border
  friend bool operator==(const Line&, const Line&) = default;
};

struct Point {
  glm::dvec3 at{0};
  Rgba colour{};
  PointShape shape = PointShape::disc;
  float radius_px = 4;
  float hidden = faintly;
  double room = 0;  // it shrinks to what it has of this length in mesh space, so that many stay apart; 0: it does not
  bool fades = false;  // where its room is a few pixels there is none, as of the dots of the surface
  friend bool operator==(const Point&, const Point&) = default;
};

// A translucent, two-sided triangle.
struct GhostTriangle {
  std::array<glm::dvec3, 3> corners{};
  Rgba colour{};
  float hidden = faintly;
  friend bool operator==(const GhostTriangle&, const GhostTriangle&) = default;
};

// Drawn in this order: ghosts, lines, points; each list in its own order.
struct Overlay {
  std::vector<GhostTriangle> ghosts;
  std::vector<Line> lines;
  std::vector<Point> points;

  bool empty() const { return ghosts.empty() && lines.empty() && points.empty(); }
};

}  // namespace ryosen
