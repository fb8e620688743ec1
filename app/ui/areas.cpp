#include "app/ui/areas.h"

#include <algorithm>
#include <cmath>

#include "app/ui/style.h"

namespace ryosen {

namespace {

// At scale 1.
constexpr int least_window_px = 900;  // that has columns
constexpr int least_view_px = 200;
constexpr float tabs_px = 30;  // the width of a strip

int scaled(float px, float scale) { return static_cast<int>(std::lround(px * scale)); }

// The height of ImGui's menu bar, and of the status line: font size plus vertical padding.
int bar_px(const UiSize& size) {
  return static_cast<int>(std::round(static_cast<float>(size.font_px) * size.scale) +
                          2 * std::floor(frame_padding_px * size.scale));
}

}  // namespace

float UiSize::of_columns() const {
  return scale * std::max(1.f, static_cast<float>(font_px) / static_cast<float>(UiSize().font_px));
}

Areas areas_of(const Layout& layout, Size window, const UiSize& size) {
  const float scale = size.of_columns();
  Areas areas;
  areas.has_tabs = static_cast<float>(window.width) < least_window_px * scale;
  const int bar = bar_px(size);
  const auto width = [&](PanelPlace side) {
    if (layout.is_empty(side)) return 0;
    if (!areas.has_tabs) return scaled(static_cast<float>(layout.width_px(side)), scale);
    return scaled(tabs_px, scale);
  };
  int left = width(PanelPlace::left), right = width(PanelPlace::right);
  const int room = std::max(window.width - scaled(least_view_px, scale), 0);
  if (!areas.has_tabs && left + right > room) {
    left = static_cast<int>(std::int64_t{left} * room / (left + right));
    right = std::min(right, room - left);
  }
  areas.view = {left, bar, window.width - right, window.height - bar};
  areas.view.x1 = std::max(areas.view.x1, areas.view.x0 + 1);
  areas.view.y1 = std::max(areas.view.y1, areas.view.y0 + 1);
  areas.left = {0, bar, areas.view.x0, areas.view.y1};
  areas.right = {areas.view.x1, bar, window.width, areas.view.y1};
  return areas;
}

int widest_column_px(const Layout& layout, PanelPlace side, Size window, float column_scale) {
  const PanelPlace other = side == PanelPlace::left ? PanelPlace::right : PanelPlace::left;
  const int taken = layout.is_empty(other) ? 0 : layout.width_px(other);
  const auto room = static_cast<int>(static_cast<float>(window.width) / column_scale) - taken - least_view_px;
  return std::clamp(room, least_column_px, most_column_px);
}

}  // namespace ryosen
