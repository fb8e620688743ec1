#include "render/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "core/base/enum_table.h"
#include "core/highlights/highlight_table.h"

namespace ryosen {
namespace {

const Looks& looks_of(std::string_view id) { return find_highlight(id)->looks; }

TEST(palette, colours_of_the_design) {
  for (const Theme theme : {Theme::dark, Theme::light}) {
    EXPECT_EQ(style(Role::hover, theme).colour, rgb(0xF0E442));
    EXPECT_EQ(style(Role::selected, theme).colour, rgb(0xE69F00));
    EXPECT_EQ(style(looks_of("boundary"), theme).colour, rgb(0x56B4E9));
    EXPECT_EQ(style(looks_of("nonmanifold"), theme).colour, rgb(0xD55E00));
    EXPECT_EQ(style(looks_of("degenerate"), theme).colour, rgb(0xCC79A7));
    EXPECT_EQ(style(Role::legal, theme).colour, rgb(0x009E73));
    EXPECT_EQ(style(Role::refused, theme).colour, rgb(0xD55E00));
  }
  EXPECT_EQ(looks_of("boundary").line, LineStyle::solid);
  EXPECT_EQ(looks_of("nonmanifold").line, LineStyle::dash_dot);
  EXPECT_EQ(looks_of("degenerate").line, LineStyle::dotted);
  EXPECT_EQ(looks_of("degenerate").point, PointShape::cross);
  EXPECT_EQ(style(Role::legal, Theme::dark).line, LineStyle::solid);
  EXPECT_EQ(style(Role::refused, Theme::dark).line, LineStyle::dashed);
}

// Highlights are shown together: line style and point shape alone must tell them apart.
TEST(palette, highlights_differ_without_colour) {
  std::set<std::pair<LineStyle, PointShape>> signs;
  for (const HighlightRow& row : highlight_table()) {
    if (row.kinds.contains(ProblemKind::isolated_vertex)) continue;  // never a line
    EXPECT_TRUE(signs.insert({row.looks.line, row.looks.point}).second) << row.id;
  }
  EXPECT_NE(style(Role::legal, Theme::dark).line, style(Role::refused, Theme::dark).line);
  EXPECT_NE(style(Role::hover, Theme::dark).point, style(Role::selected, Theme::dark).point);
}

TEST(palette, every_role_and_highlight_is_seen_on_both_grounds) {
  const auto brightness = [](Rgba c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; };
  for (const Theme theme : {Theme::dark, Theme::light}) {
    const double ground = brightness(palette(theme).background_top);
    const auto expect_seen = [&](const Style& s, std::string_view what) {
      EXPECT_GT(s.width_px, 1) << what;
      EXPECT_GT(s.radius_px, 3) << what;
      EXPECT_GT(std::abs(brightness(s.colour) - ground), 20) << what;
    };
    for (std::size_t role = 0; role < enum_count<Role>; ++role)
      expect_seen(style(static_cast<Role>(role), theme), std::to_string(role));
    for (const HighlightRow& row : highlight_table()) expect_seen(style(row.looks, theme), row.id);
  }
}

}  // namespace
}  // namespace ryosen
