// The axes X, Y, Z in the corner of a view, as they are turned there. A click on an end of one looks at the mesh from
// that side. What draws them and what asks which is under the pointer read the same places.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "ryosen/scene/view/camera.h"

namespace ryosen {

struct AxisEnd {
  int axis;  // 0, 1, 2
  bool is_negative;
  std::string_view name;  // "+X"
  std::string_view view;  // the named view that looks from there
};

struct PlacedAxisEnd {
  const AxisEnd* end;
  glm::dvec2 pixel;  // of the middle of its disc in the view
  double radius_px;
};

struct CornerAxes {
  glm::dvec2 middle;                  // in pixels of the view
  std::array<PlacedAxisEnd, 6> ends;  // the farthest from the eye first
};

// All that they may cover, however they are turned; none where the view has no room for them.
std::optional<PixelRect> room_of_axes(Size view, double scale);
// In the upper right corner, sized by the scale of the display; none where there is no such room.
std::optional<CornerAxes> corner_axes(const Camera& camera, Size view, double scale);
// The nearest to the eye at a pixel of the view; null where there is none.
const AxisEnd* end_at(const CornerAxes& axes, glm::dvec2 pixel);
// The command that looks from there; where the camera does so already, from the opposite side.
std::string line_of(const AxisEnd& end, const Camera& camera);

}  // namespace ryosen
