#include "render/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/base/enum_table.h"
#include "ryosen/scene/highlights/highlight_table.h"
#include "tests/support/render/colour_difference.h"

namespace ryosen {
namespace {

const Looks& looks_of(std::string_view id) { return find_highlight(id)->looks; }

TEST(palette, signs_of_the_design) {
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

struct NamedColour {
  std::string name;
  Rgba colour;
};

// What can stand beside each other in a picture and has to be told apart.
std::vector<NamedColour> colours_that_meet(Theme theme) {
  std::vector<NamedColour> met;
  for (const auto& [name, role] : {std::pair("hover", Role::hover), std::pair("selected", Role::selected),
                                   std::pair("legal", Role::legal), std::pair("refused", Role::refused)})
    met.push_back({name, style(role, theme).colour});
  for (const char* const id : {"boundary", "nonmanifold", "misoriented", "degenerate", "hanging"})
    met.push_back({id, style(looks_of(id), theme).colour});
  return met;
}

// In every pair, for all kinds of sight, whatever the pattern.
TEST(palette, colours_that_meet_differ_for_the_colour_blind_too) {
  constexpr double least = 12;
  for (const Theme theme : {Theme::dark, Theme::light})
    for (const test::Sight sight : {test::Sight::usual, test::Sight::deuteranopia, test::Sight::protanopia}) {
      const std::vector<NamedColour> met = colours_that_meet(theme);
      for (std::size_t i = 0; i < met.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GE(test::ciede2000(test::lab_as_seen(met[i].colour, sight), test::lab_as_seen(met[j].colour, sight)),
                    least)
              << met[i].name << " and " << met[j].name << " in theme " << static_cast<int>(theme) << ", sight "
              << static_cast<int>(sight);
    }
}

// In the light that the surface has from its brightest side to its shadows.
TEST(palette, hover_and_selection_are_clear_on_the_surface) {
  for (const Theme theme : {Theme::dark, Theme::light})
    for (const test::Sight sight : {test::Sight::usual, test::Sight::deuteranopia, test::Sight::protanopia})
      for (const Role role : {Role::hover, Role::selected})
        for (const double light : {1.0, 0.8, 0.6}) {
          Rgba tone = palette(theme).front;
          for (std::size_t i = 0; i < 3; ++i) tone[i] = static_cast<std::uint8_t>(light * tone[i]);
          EXPECT_GE(
              test::ciede2000(test::lab_as_seen(style(role, theme).colour, sight), test::lab_as_seen(tone, sight)), 15)
              << static_cast<int>(role) << " in theme " << static_cast<int>(theme) << ", sight "
              << static_cast<int>(sight) << ", light " << light;
        }
}

// Published pairs that reach each branch of the formula [Sharma05].
TEST(palette, difference_of_colours_is_the_published_one) {
  using test::Lab;
  const auto expect = [](const Lab& a, const Lab& b, double difference) {
    EXPECT_NEAR(test::ciede2000(a, b), difference, 5e-5);
    EXPECT_NEAR(test::ciede2000(b, a), difference, 5e-5);
  };
  expect({50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425);
  expect({50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000);
  expect({50, 0, 0}, {50, -1, 2}, 2.3669);
  expect({50, 2.49, -0.001}, {50, -2.49, 0.0009}, 7.1792);
  expect({50, 2.5, 0}, {73, 25, -18}, 27.1492);
  expect({50, 2.5, 0}, {58, 24, 15}, 19.4535);
  expect({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644);
  expect({2.0776, 0.0795, -1.135}, {0.9033, -0.0636, -0.5514}, 0.9082);
}

}  // namespace
}  // namespace ryosen
