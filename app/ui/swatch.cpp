#include "app/ui/swatch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/ui/style.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

// What overlay.frag draws of a line style, in widths of the line: strokes of these lengths around these places of each
// period. A round one is a dot.
struct DashRow {
  LineStyle style;
  float period;
  std::array<float, 2> middles, lengths;
  bool is_round = false;
};
constexpr DashRow dash_rows[] = {
    {LineStyle::solid, 0, {}, {}},
    {LineStyle::dashed, 3.4f, {0, 0}, {2, 0}},
    {LineStyle::dash_dot, 6, {0, 3}, {2.8f, 1}},
    {LineStyle::dotted, 2, {0, 0}, {1, 0}, true},
};
static_assert(rows_are_in_order(dash_rows, &DashRow::style));

float fraction(float t) { return t - std::floor(t); }

// As pattern.glsl has both, with y downwards.
float pattern_light(FacePattern pattern, float x) {
  return pattern == FacePattern::bars && fraction(x / 8) > 0.3f ? 0.f : 1.f;
}
float pattern_share(FacePattern pattern, float x, float y) {
  const auto is_on = [](float t) { return fraction(t) >= 0.5f; };
  if (pattern == FacePattern::diagonal) return is_on((x + y) / 10) ? 1 : 0.55f;
  if (pattern == FacePattern::chessboard) return is_on((x + y) / 10) != is_on((x - y) / 10) ? 1 : 0.5f;
  if (pattern == FacePattern::horizontal) return is_on(y / 6) ? 1 : 0.5f;
  if (pattern == FacePattern::bars) return fraction(x / 8) <= 0.5f ? 1 : 0;
  return 1;
}

class Sample {
 public:
  Sample(ImVec2 at, ImVec2 size, const Style& style, Theme theme, float scale)
      : list_(*ImGui::GetWindowDrawList()), at_(at), size_(size), style_(style), theme_(theme), scale_(scale) {}

  void draw(const SwatchParts& parts) {
    ImGui::PushClipRect(at_, {at_.x + size_.x, at_.y + size_.y}, true);
    if (parts.tint) draw_tint(*parts.tint);
    if (parts.has_line) draw_line();
    if (parts.has_point) {
      const Rgba outline = palette(theme_).outline;
      draw_point(style_.radius_px * scale_ + 1.3f * scale_, outline, 1.3f * scale_);
      draw_point(style_.radius_px * scale_, style_.colour, 0);
    }
    ImGui::PopClipRect();
  }

 private:
  ImVec2 middle() const { return {at_.x + 0.5f * size_.x, at_.y + 0.5f * size_.y}; }
  Rgba mixed(Rgba below, Rgba above, float share) const {
    for (std::size_t i = 0; i < 3; ++i)
      below[i] = static_cast<std::uint8_t>(std::lround(std::lerp(float(below[i]), float(above[i]), share)));
    return below;
  }

  // A row of pixels at a time, in pieces of one colour.
  void draw_tint(const FaceTint& tint) {
    const Rgba face = palette(theme_).front;
    const auto share_at = [&](float x, float y) { return pattern_share(tint.pattern, x / scale_, y / scale_); };
    const auto colour_at = [&](float x) { return mixed({}, style_.colour, pattern_light(tint.pattern, x / scale_)); };
    for (float y = 0; y < size_.y; ++y)
      for (float x = 0, end = 0; x < size_.x; x = end) {
        const float share = share_at(x, y);
        const Rgba colour = colour_at(x);
        while (end < size_.x && share_at(end, y) == share && colour_at(end) == colour) ++end;
        list_.AddRectFilled({at_.x + x, at_.y + y}, {at_.x + std::min(end, size_.x), at_.y + y + 1},
                            to_imgui32(mixed(face, colour, tint.strength * share)));
      }
  }

  void draw_line() {
    const DashRow& row = dash_rows[static_cast<std::size_t>(style_.line)];
    const float width = style_.width_px * scale_, y = middle().y;
    const ImU32 colour = to_imgui32(style_.colour);
    const auto stroke = [&](float from, float to) {
      list_.AddRectFilled({from, y - 0.5f * width}, {to, y + 0.5f * width}, colour);
    };
    if (row.period == 0) return stroke(at_.x, at_.x + size_.x);
    const float period = row.period * width;
    for (float start = middle().x - 4 * period; start < at_.x + size_.x + period; start += period)
      for (std::size_t i = 0; i < row.lengths.size(); ++i) {
        const float there = start + row.middles[i] * width, half = 0.5f * row.lengths[i] * width;
        if (half == 0 || there + half < at_.x || there - half > at_.x + size_.x) continue;
        if (row.is_round)
          list_.AddCircleFilled({there, y}, half, colour, 16);
        else
          stroke(there - half, there + half);
      }
  }

  // `more` is what an outline adds to the thickness of what is thin.
  void draw_point(float radius, Rgba shown, float more) {
    const ImU32 colour = to_imgui32(shown);
    const auto [x, y] = middle();
    const float own = radius - more;
    switch (style_.point) {
      case PointShape::disc:
        return list_.AddCircleFilled({x, y}, radius, colour, 24);
      case PointShape::ring:
        return list_.AddCircle({x, y}, 0.78f * own, colour, 24, 0.44f * own + 2 * more);
      case PointShape::square:
        return list_.AddRectFilled({x - 0.8f * own - more, y - 0.8f * own - more},
                                   {x + 0.8f * own + more, y + 0.8f * own + more}, colour);
      case PointShape::diamond: {
        const float reach = (0.75f * own + more) * 1.414f;
        return list_.AddQuadFilled({x - reach, y}, {x, y - reach}, {x + reach, y}, {x, y + reach}, colour);
      }
      case PointShape::cross: {
        const float reach = (own + more) * 0.7071f, thickness = 0.44f * own + 2 * more;
        list_.AddLine({x - reach, y - reach}, {x + reach, y + reach}, colour, thickness);
        return list_.AddLine({x - reach, y + reach}, {x + reach, y - reach}, colour, thickness);
      }
    }
  }

  ImDrawList& list_;
  ImVec2 at_, size_;
  const Style& style_;
  Theme theme_;
  float scale_;
};

}  // namespace

SwatchParts parts_of(const HighlightRow& row) {
  SwatchParts parts{.tint = row.tint};
  for_each_mark(row, [&](Mark mark) {
    const bool is_face = mark.sort == Element::Kind::face, is_vertex = mark.sort == Element::Kind::vertex;
    parts.has_line |= !is_vertex;
    parts.has_point |= is_vertex || is_face;
  });
  return parts;
}

void swatch(const HighlightRow& row, Theme theme, float width_px, float scale) {
  const ImVec2 size{width_px, ImGui::GetFontSize()}, cursor = ImGui::GetCursorScreenPos();
  ImGui::Dummy(size);
  const Style looks = style(row.looks, theme);
  Sample({std::floor(cursor.x), std::floor(cursor.y)}, size, looks, theme, scale).draw(parts_of(row));
}

}  // namespace ryosen
