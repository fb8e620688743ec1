#include "app/editor/input/corner_axes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

// In pixels at display scale 1.
constexpr double arm = 34, positive_radius = 9, negative_radius = 7, corner_margin = 14, least_view = 240;

constexpr std::array<AxisEnd, 6> axis_ends{{
    {0, false, "+X", "right"},
    {0, true, "-X", "left"},
    {1, false, "+Y", "top"},
    {1, true, "-Y", "bottom"},
    {2, false, "+Z", "front"},
    {2, true, "-Z", "back"},
}};

glm::dvec3 direction_of(const AxisEnd& end) {
  glm::dvec3 direction(0);
  direction[end.axis] = end.is_negative ? -1 : 1;
  return direction;
}

bool has_room(Size view, double scale) { return std::min(view.width, view.height) >= least_view * scale; }

}  // namespace

// With a margin for what is drawn at a place there.
std::optional<PixelRect> room_of_axes(Size view, double scale) {
  if (!has_room(view, scale)) return std::nullopt;
  const int side = static_cast<int>(std::ceil((2 * (arm + positive_radius) + 2 * corner_margin) * scale));
  return PixelRect{view.width - side, 0, view.width, side};
}

std::optional<CornerAxes> corner_axes(const Camera& camera, Size view, double scale) {
  if (!has_room(view, scale)) return std::nullopt;
  const CameraAxes a = axes(camera);
  const double away = (corner_margin + arm + positive_radius) * scale;
  CornerAxes made{{view.width - away, away}, {}};
  for (std::size_t i = 0; i < axis_ends.size(); ++i) {
    const AxisEnd& end = axis_ends[i];
    const glm::dvec3 direction = direction_of(end);
    const glm::dvec2 off(glm::dot(direction, a.right), -glm::dot(direction, a.up));
    made.ends[i] = {&end, made.middle + off * (arm * scale),
                    (end.is_negative ? negative_radius : positive_radius) * scale};
  }
  std::stable_sort(made.ends.begin(), made.ends.end(), [&](const PlacedAxisEnd& x, const PlacedAxisEnd& y) {
    return glm::dot(direction_of(*x.end), a.forward) > glm::dot(direction_of(*y.end), a.forward);
  });
  return made;
}

const AxisEnd* end_at(const CornerAxes& axes, glm::dvec2 pixel) {
  const AxisEnd* found = nullptr;
  for (const PlacedAxisEnd& placed : axes.ends)
    if (glm::length(pixel - placed.pixel) <= placed.radius_px) found = placed.end;
  return found;
}

std::string line_of(const AxisEnd& end, const Camera& camera) {
  const bool is_there = glm::dot(direction_of(end), axes(camera).forward) < -1 + 1e-9;
  const auto opposite = std::find_if(axis_ends.begin(), axis_ends.end(), [&](const AxisEnd& other) {
    return other.axis == end.axis && other.is_negative != end.is_negative;
  });
  return "view " + std::string(is_there ? opposite->view : end.view) + " here";
}

}  // namespace ryosen
