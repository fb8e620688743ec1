#include "render/palette.h"

#include "ryosen/base/enum_table.h"

namespace ryosen {
namespace {

struct RoleRow {
  Role role;
  Looks looks;
  std::uint8_t alpha = 255;
};

constexpr RoleRow role_rows[] = {
    {Role::hover, {0xFFF070, 0x370098, LineStyle::solid, 4, PointShape::disc, 6}},
    {Role::selected, {0xEBA509, 0xF8A519, LineStyle::solid, 3.5f, PointShape::square, 5}},
    {Role::legal, {0x099D5C, 0x2EA361, LineStyle::solid, 4.5f, PointShape::disc, 5.5f}},
    {Role::refused, {0xE35000, 0xDD5310, LineStyle::dashed, 4.5f, PointShape::cross, 7}},
    {Role::witness, {0xFFFFFF, 0x000000, LineStyle::dotted, 3.5f, PointShape::diamond, 6}},
    {Role::ghost, {0x5FE0B8, 0x009E73, LineStyle::solid, 1.5f, PointShape::ring, 5}, 96},
    {Role::goes, {0x06281F, 0x06281F, LineStyle::dashed, 1.75f, PointShape::ring, 5}},
};
static_assert(rows_are_in_order(role_rows, &RoleRow::role));

constexpr Palette palette_of(bool is_dark) {
  // The first of two in the dark theme, the other in the light one.
  const auto either = [&](Rgba dark, Rgba light) { return is_dark ? dark : light; };
  return {
      .background_top = either(rgb(0x323A46), rgb(0xFAFBFC)),
      .background_bottom = either(rgb(0x15191F), rgb(0xD3DAE3)),
      .front = either(rgb(0xC4C6CA), rgb(0xD2D4D8)),
      .back = either(rgb(0x9C6148), rgb(0xBE8467)),
      .key = either(rgb(0xFFF0DC), rgb(0xFFF4E6)),
      .fill = either(rgb(0x5D7399), rgb(0x6F86AC)),
      .rim = either(rgb(0x3C4E66), rgb(0x2C3A4C)),
      .wire = either(rgb(0x0C1018, 170), rgb(0x141A26, 150)),
      .film = either(rgb(0x141A24), rgb(0x1E1812)),
      .film_wire = either(rgb(0x4A6078), rgb(0x705C48)),
      .label = either(rgb(0xF2F4F7), rgb(0x12161C)),
      .label_ground = either(rgb(0x12161C, 190), rgb(0xFFFFFF, 205)),
      .outline = either(rgb(0x0C1018, 220), rgb(0x202630, 220)),
      .cut = either(rgb(0x0C1018), rgb(0x0C1018)),
      .grid = either(rgb(0xA9B8CC, 150), rgb(0x4A5A70, 150)),
      .axes = {either(rgb(0xF0524A), rgb(0xE23A3A)), either(rgb(0x8CD04A), rgb(0x7CC63C)),
               either(rgb(0x4A90FF), rgb(0x2E6FE0))},
  };
}
constexpr Palette dark_palette = palette_of(true), light_palette = palette_of(false);

}  // namespace

Style style(const Looks& looks, Theme theme) {
  return {rgb(theme == Theme::dark ? looks.dark : looks.light), looks.line, looks.width_px, looks.point,
          looks.radius_px};
}

Style style(Role role, Theme theme) {
  const RoleRow& row = role_rows[static_cast<std::size_t>(role)];
  Style result = style(row.looks, theme);
  result.colour = with_alpha(result.colour, row.alpha);
  return result;
}

const Palette& palette(Theme theme) { return theme == Theme::dark ? dark_palette : light_palette; }

}  // namespace ryosen
