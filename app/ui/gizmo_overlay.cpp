// How the handles of the selection and the axes in the corner are drawn, and what guides the eye while the selection is
// moved, turned or scaled.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "app/editor/camera/view_state.h"
#include "app/editor/input/gizmo.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/pointing.h"
#include "app/editor/shown/gesturing.h"
#include "app/ui/overlays.h"

namespace ryosen {

namespace {

constexpr float behind_surface = 0.6f;  // of what the surface hides: the middle mostly lies within it

// Strokes on a dark rim, so that they are seen on any ground; without it where they are hidden.
class HandlePainter {
 public:
  HandlePainter(Overlay& overlay, Theme theme) : overlay_(overlay), theme_(theme) {}

  void draw(const GizmoHandle& handle, bool is_pointed) {
    const Rgba colour = is_pointed ? style(Role::hover, theme_).colour : colour_of(handle.row->way);
    const float width = is_pointed ? 4.5f : 3;
    if (handle.plate.size() == 4) {
      const std::vector<glm::dvec3>& p = handle.plate;
      const Rgba fill = with_alpha(colour, is_pointed ? 200 : 130);
      overlay_.ghosts.push_back({{p[0], p[1], p[2]}, fill, behind_surface});
      overlay_.ghosts.push_back({{p[0], p[2], p[3]}, fill, behind_surface});
    }
    draw(handle.strokes, colour, handle.plate.empty() ? width : 0.6f * width);
    draw(handle.letter, colour, 2.25f);
  }
  void draw(std::span<const GizmoStroke> strokes, Rgba colour, float width_px) {
    const Rgba rim = palette(theme_).outline;
    for (const GizmoStroke& s : strokes)
      overlay_.lines.push_back({s.a, s.b, rim, LineStyle::solid, width_px, 0, s.arrow, false, true});
    for (const GizmoStroke& s : strokes)
      overlay_.lines.push_back({s.a, s.b, colour, LineStyle::solid, width_px, behind_surface, s.arrow});
  }

 private:
  // A plate has the colour of the axis across it.
  Rgba colour_of(HandleWay way) const {
    const auto& axes = palette(theme_).axes;
    if (const auto axis = axis_of(way)) return axes[static_cast<std::size_t>(*axis)];
    if (const auto plane = plane_of(way)) return axes[static_cast<std::size_t>(3 - (*plane)[0] - (*plane)[1])];
    return rgb(0xF4F6F8);
  }

  Overlay& overlay_;
  Theme theme_;
};

// Lines that show what a gesture is bound to, through its middle.
class Guides {
 public:
  Guides(const ViewState& view, const TransformGesture& gesture, Theme theme, Overlay& overlay)
      : view_(view), gesture_(gesture), theme_(theme), overlay_(overlay) {
    const Camera& camera = view.camera;
    const double depth = depth_of(camera, gesture.middle());
    reach_ = 2 * units_per_pixel(camera, view.size, depth) * (view.size.width + view.size.height);
  }

  void draw() {
    draw_axes();
    if (gesture_.has_falloff()) draw_falloff();
    if (const SnapTarget* const target = gesture_.snapped_to()) {
      const Style hover = style(Role::hover, theme_);
      overlay_.points.push_back({target->place, hover.colour, PointShape::ring, 10, 1});
      overlay_.points.push_back({target->place, hover.colour, PointShape::cross, 5, 1});
    }
  }

 private:
  void draw_axes() {
    const auto& axes = palette(theme_).axes;
    const std::size_t number = std::string_view("XYZ").find(gesture_.axis_letter());
    if (!gesture_.axis()) return;
    if (number == std::string_view::npos) {
      if (!gesture_.is_in_plane()) line(*gesture_.axis(), style(Role::hover, theme_).colour);
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      glm::dvec3 axis(0);
      axis[static_cast<int>(k)] = 1;
      if ((k == number) != gesture_.is_in_plane()) line(axis, axes[k]);
    }
  }
  void line(const glm::dvec3& along, Rgba colour) {
    const glm::dvec3 middle = gesture_.middle();
    overlay_.lines.push_back(
        {middle - reach_ * along, middle + reach_ * along, colour, LineStyle::solid, 2, behind_surface});
  }

  // As far as it reaches in the plane of the view.
  void draw_falloff() {
    constexpr int sides = 64;
    const CameraAxes camera = axes(view_.camera);
    const auto corner = [&](int i) {
      const double angle = 2 * std::numbers::pi * (i % sides) / sides;
      return gesture_.middle() + gesture_.falloff() * (std::cos(angle) * camera.right + std::sin(angle) * camera.up);
    };
    for (int i = 0; i < sides; ++i)
      overlay_.lines.push_back(
          {corner(i), corner(i + 1), style(Role::witness, theme_).colour, LineStyle::solid, 1.75f, 1});
  }

  const ViewState& view_;
  const TransformGesture& gesture_;
  Theme theme_;
  Overlay& overlay_;
  double reach_;
};

}  // namespace

Overlay gizmo_overlay(const ViewState& view, const Pointing& pointing, const Gesturing& gesturing, Theme theme) {
  Overlay overlay;
  if (const TransformGesture* const gesture = gesturing.transform()) {
    Guides(view, *gesture, theme, overlay).draw();
    return overlay;
  }
  const auto gizmo = pointing.gizmo();
  if (!gizmo) return overlay;
  HandlePainter painter(overlay, theme);
  for (const GizmoHandle& handle : gizmo->handles) painter.draw(handle, handle.row == pointing.pointed_handle());
  return overlay;
}

Overlay axes_overlay(const ViewState& view, const Pointing& pointing, const Preferences& preferences, Theme theme) {
  constexpr float arm_px = 2.5f, letter_px = 1.6f;
  Overlay overlay;
  const auto corner = pointing.axes_in_corner();
  if (!corner) return overlay;
  // In pixels of the view, on the plane of the target of the camera.
  const double depth = depth_of(view.camera, view.camera.target);
  const auto line = [&](glm::dvec2 a, glm::dvec2 b, Rgba colour, float width_px) {
    const auto at = [&](glm::dvec2 pixel) { return place_at(view.camera, view.size, pixel, depth); };
    overlay.lines.push_back({at(a), at(b), colour, LineStyle::solid, width_px, 1});
  };
  // A line without length is as round as it is wide.
  const auto disc = [&](const PlacedAxisEnd& placed, double share, Rgba colour) {
    line(placed.pixel, placed.pixel, colour,
         static_cast<float>(2 * share * placed.radius_px / preferences.size_scale()));
  };
  const Rgba ink = rgb(0x0C1018);
  for (const PlacedAxisEnd& placed : corner->ends) {
    const bool is_pointed = placed.end == pointing.pointed_axis_end();
    const Rgba colour = palette(theme).axes[static_cast<std::size_t>(placed.end->axis)];
    if (!placed.end->is_negative) line(corner->middle, placed.pixel, colour, arm_px);
    disc(placed, 1, is_pointed ? rgb(0xFFFFFF) : colour);
    if (placed.end->is_negative && !is_pointed) {
      disc(placed, 0.72, palette(theme).background_bottom);
      continue;
    }
    const double size = 0.42 * placed.radius_px;
    for (const LetterStroke& stroke : axis_letter(placed.end->axis))
      line(placed.pixel + glm::dvec2(stroke.a.x, -stroke.a.y) * size,
           placed.pixel + glm::dvec2(stroke.b.x, -stroke.b.y) * size, ink, letter_px);
  }
  return overlay;
}

}  // namespace ryosen
