#include "app/ui/axes_overlay.h"

#include <utility>

#include "app/editor/camera/view_state.h"
#include "app/editor/input/axis_letters.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/pointing.h"

namespace ryosen {

namespace {

// Draws in pixels of the view, on the plane of the target of the camera.
class CornerPainter {
 public:
  CornerPainter(const ViewState& view, const Pointing& pointing, const Preferences& preferences,
                const CornerAxes& corner, Theme theme)
      : view_(view),
        pointing_(pointing),
        preferences_(preferences),
        corner_(corner),
        theme_(theme),
        depth_(depth_of(view.camera, view.camera.target)) {}

  Overlay drawn() {
    for (const PlacedAxisEnd& placed : corner_.ends) draw(placed);
    return std::move(overlay_);
  }

 private:
  void draw(const PlacedAxisEnd& placed) {
    const bool is_pointed = placed.end == pointing_.pointed_axis_end();
    const Rgba colour = palette(theme_).axes[static_cast<std::size_t>(placed.end->axis)];
    const Rgba ink = rgb(0x0C1018);
    if (placed.end->is_negative) {
      disc(placed, 1, is_pointed ? rgb(0xFFFFFF) : colour);
      if (!is_pointed) disc(placed, 0.72, palette(theme_).background_bottom);
    } else {
      line(corner_.middle, placed.pixel, colour, arm_px);
      disc(placed, 1, is_pointed ? rgb(0xFFFFFF) : colour);
    }
    if (placed.end->is_negative && !is_pointed) return;
    const double size = 0.42 * placed.radius_px;
    for (const LetterStroke& stroke : axis_letter(placed.end->axis))
      line(placed.pixel + glm::dvec2(stroke.a.x, -stroke.a.y) * size,
           placed.pixel + glm::dvec2(stroke.b.x, -stroke.b.y) * size, ink, letter_px);
  }

  // A line without length is as round as it is wide.
  void disc(const PlacedAxisEnd& placed, double share, Rgba colour) {
    line(placed.pixel, placed.pixel, colour,
         static_cast<float>(2 * share * placed.radius_px / preferences_.size_scale()));
  }
  void line(glm::dvec2 a, glm::dvec2 b, Rgba colour, float width_px) {
    const auto at = [&](glm::dvec2 pixel) { return place_at(view_.camera, view_.size, pixel, depth_); };
    overlay_.lines.push_back({at(a), at(b), colour, LineStyle::solid, width_px, 1});
  }

  static constexpr float arm_px = 2.5f, letter_px = 1.6f;
  const ViewState& view_;
  const Pointing& pointing_;
  const Preferences& preferences_;
  const CornerAxes& corner_;
  Theme theme_;
  double depth_;
  Overlay overlay_;
};

}  // namespace

Overlay axes_overlay(const ViewState& view, const Pointing& pointing, const Preferences& preferences, Theme theme) {
  const auto corner = pointing.axes_in_corner();
  return corner ? CornerPainter(view, pointing, preferences, *corner, theme).drawn() : Overlay();
}

}  // namespace ryosen
