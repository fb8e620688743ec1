// The arrows of links, as they are drawn.
#include "app/editor/labels/drawn_links.h"
#include "app/ui/overlays.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

// The looks of an arrow by its role; line style and label tell apart what colours may not.
struct LinkLooks {
  LinkRole role;
  std::uint32_t dark, light;  // 0xRRGGBB
  LineStyle line;
  float width_px;
};
constexpr LinkLooks link_looks[] = {
    {LinkRole::all, 0x8FC7FF, 0x1F5FA8, LineStyle::solid, 1.6f},
    {LinkRole::trail, 0xF0E442, 0x8A7A00, LineStyle::dotted, 2.2f},
    {LinkRole::itself, 0xE69F00, 0xB36B00, LineStyle::solid, 3.4f},
    {LinkRole::next, 0x2BD9A0, 0x007A58, LineStyle::solid, 2.6f},
    {LinkRole::prev, 0x56B4E9, 0x0062A3, LineStyle::dashed, 2.6f},
    {LinkRole::twin, 0xE58CC0, 0x9E3D78, LineStyle::dash_dot, 2.6f},
    {LinkRole::vertex, 0xFFFFFF, 0x202020, LineStyle::solid, 2.2f},
    {LinkRole::face, 0xFFFFFF, 0x202020, LineStyle::dotted, 2.0f},
    {LinkRole::around, 0x56B4E9, 0x0062A3, LineStyle::solid, 2.2f},
    {LinkRole::wing, 0x56B4E9, 0x0062A3, LineStyle::solid, 2.4f},
    {LinkRole::ring, 0xE58CC0, 0x9E3D78, LineStyle::dashed, 2.4f},
    {LinkRole::normal, 0xFFFFFF, 0x202020, LineStyle::solid, 2.2f},
};
static_assert(rows_are_in_order(link_looks, &LinkLooks::role));

// Text 003 draws what has no opposite in another colour.
constexpr std::uint32_t boundary_dark = 0x2BD9A0, boundary_light = 0x00785A;

}  // namespace

Overlay links_overlay(std::span<const LinkArrow> arrows, Theme theme) {
  Overlay overlay;
  const bool is_dark = theme == Theme::dark;
  for (const LinkArrow& arrow : arrows) {
    const LinkLooks& looks = link_looks[static_cast<std::size_t>(arrow.role)];
    std::uint32_t colour = is_dark ? looks.dark : looks.light;
    if (arrow.role == LinkRole::all && arrow.is_boundary) colour = is_dark ? boundary_dark : boundary_light;
    const float hidden = arrow.role == LinkRole::all ? 0 : faintly;
    // The shaft of a thin one has an edge that sets it off from a surface of any brightness.
    if (arrow.role == LinkRole::all)
      overlay.lines.push_back(
          {arrow.from, arrow.to, palette(theme).outline, looks.line, looks.width_px + 1.8f, hidden, false});
    if (arrow.from == arrow.to)
      overlay.points.push_back({arrow.from, rgb(colour), PointShape::ring, 8, hidden});
    else
      overlay.lines.push_back({arrow.from, arrow.to, rgb(colour), looks.line, looks.width_px, hidden, true});
  }
  return overlay;
}

}  // namespace ryosen
