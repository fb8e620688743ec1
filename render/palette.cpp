#include "render/palette.h"

namespace ryosen {
namespace {

struct Row {
  Role role;
  Rgba dark, light;
  LineStyle line;
  float width_px;
  PointShape point;
  float radius_px;
};

// In the order of Role.
constexpr Row role_rows[role_count] = {
    {Role::hover, rgb(0xF0E442), rgb(0xF0E442), LineStyle::solid, 4, PointShape::disc, 6},
    {Role::selected, rgb(0xE69F00), rgb(0xE69F00), LineStyle::solid, 3.5f, PointShape::square, 5},
    {Role::legal, rgb(0x009E73), rgb(0x009E73), LineStyle::solid, 4.5f, PointShape::disc, 5.5f},
    {Role::refused, rgb(0xD55E00), rgb(0xD55E00), LineStyle::dashed, 4.5f, PointShape::cross, 7},
    {Role::witness, rgb(0xFFFFFF), rgb(0x000000), LineStyle::dotted, 3.5f, PointShape::diamond, 6},
    {Role::ghost, rgb(0x5FE0B8, 96), rgb(0x009E73, 96), LineStyle::solid, 1.5f, PointShape::ring, 5},
    {Role::boundary, rgb(0x56B4E9), rgb(0x56B4E9), LineStyle::solid, 3, PointShape::ring, 4.5f},
    {Role::nonmanifold, rgb(0xD55E00), rgb(0xD55E00), LineStyle::dash_dot, 4, PointShape::diamond, 6},
    {Role::misoriented, rgb(0x4A90D9), rgb(0x0072B2), LineStyle::dashed, 3.5f, PointShape::ring, 5},
    {Role::degenerate, rgb(0xCC79A7), rgb(0xCC79A7), LineStyle::dotted, 4, PointShape::cross, 6},
    {Role::duplicate, rgb(0xBBBBBB), rgb(0x666666), LineStyle::dash_dot, 2.5f, PointShape::square, 4.5f},
    {Role::hanging, rgb(0xC77CFF), rgb(0xAA3377), LineStyle::dotted, 3, PointShape::diamond, 5},
    {Role::isolated, rgb(0xFFFFFF), rgb(0x000000), LineStyle::solid, 2, PointShape::ring, 5},
    {Role::wire, rgb(0xE4E8EE), rgb(0x303846), LineStyle::solid, 1.8f, PointShape::disc, 3.5f},
};

constexpr Palette dark_palette = {
    .background_top = rgb(0x323A46),
    .background_bottom = rgb(0x15191F),
    .front = rgb(0xC4C6CA),
    .back = rgb(0x9C6148),
    .key = rgb(0xFFF0DC),
    .fill = rgb(0x5D7399),
    .rim = rgb(0x3C4E66),
    .wire = rgb(0x0C1018, 170),
    .outline = rgb(0x0C1018, 220),
};

constexpr Palette light_palette = {
    .background_top = rgb(0xFAFBFC),
    .background_bottom = rgb(0xD3DAE3),
    .front = rgb(0xD2D4D8),
    .back = rgb(0xBE8467),
    .key = rgb(0xFFF4E6),
    .fill = rgb(0x6F86AC),
    .rim = rgb(0x2C3A4C),
    .wire = rgb(0x141A26, 150),
    .outline = rgb(0x202630, 220),
};

}  // namespace

Style style(Role role, Theme theme) {
  const Row& row = role_rows[static_cast<int>(role)];
  return {theme == Theme::dark ? row.dark : row.light, row.line, row.width_px, row.point, row.radius_px};
}

const Palette& palette(Theme theme) { return theme == Theme::dark ? dark_palette : light_palette; }

}  // namespace ryosen
