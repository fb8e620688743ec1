#include "render/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace ryosen {
namespace {

TEST(palette, colours_of_the_design) {
  for (const Theme theme : {Theme::dark, Theme::light}) {
    EXPECT_EQ(style(Role::hover, theme).colour, rgb(0xF0E442));
    EXPECT_EQ(style(Role::selected, theme).colour, rgb(0xE69F00));
    EXPECT_EQ(style(Role::boundary, theme).colour, rgb(0x56B4E9));
    EXPECT_EQ(style(Role::nonmanifold, theme).colour, rgb(0xD55E00));
    EXPECT_EQ(style(Role::degenerate, theme).colour, rgb(0xCC79A7));
    EXPECT_EQ(style(Role::legal, theme).colour, rgb(0x009E73));
    EXPECT_EQ(style(Role::refused, theme).colour, rgb(0xD55E00));
  }
  EXPECT_EQ(style(Role::boundary, Theme::dark).line, LineStyle::solid);
  EXPECT_EQ(style(Role::nonmanifold, Theme::dark).line, LineStyle::dash_dot);
  EXPECT_EQ(style(Role::degenerate, Theme::dark).line, LineStyle::dotted);
  EXPECT_EQ(style(Role::degenerate, Theme::dark).point, PointShape::cross);
  EXPECT_EQ(style(Role::legal, Theme::dark).line, LineStyle::solid);
  EXPECT_EQ(style(Role::refused, Theme::dark).line, LineStyle::dashed);
}

// Highlights are shown together: line style and point shape alone must tell them apart.
TEST(palette, highlights_differ_without_colour) {
  const Role highlights[] = {Role::boundary,  Role::nonmanifold, Role::misoriented, Role::degenerate,
                             Role::duplicate, Role::hanging,     Role::isolated};
  std::set<std::pair<LineStyle, PointShape>> signs;
  for (const Role role : highlights) {
    const Style s = style(role, Theme::dark);
    if (role == Role::isolated) continue;  // never a line
    EXPECT_TRUE(signs.insert({s.line, s.point}).second) << static_cast<int>(role);
  }
  EXPECT_NE(style(Role::legal, Theme::dark).line, style(Role::refused, Theme::dark).line);
  EXPECT_NE(style(Role::hover, Theme::dark).point, style(Role::selected, Theme::dark).point);
}

TEST(palette, every_role_is_seen_on_both_grounds) {
  const auto brightness = [](Rgba c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; };
  for (const Theme theme : {Theme::dark, Theme::light}) {
    const double ground = brightness(palette(theme).background_top);
    for (int role = 0; role < role_count; ++role) {
      const Style s = style(static_cast<Role>(role), theme);
      EXPECT_GT(s.width_px, 1);
      EXPECT_GT(s.radius_px, 3);
      EXPECT_GT(std::abs(brightness(s.colour) - ground), 20) << role;
    }
  }
}

}  // namespace
}  // namespace ryosen
