#include "ryosen/scene/highlights/colour_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace ryosen {
namespace {

// The lightness L* of CIE 1976, from sRGB.
double lightness(std::uint32_t colour) {
  const auto linear = [&](int shift) {
    const double c = (colour >> shift & 0xff) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 116 * std::cbrt(0.2126 * linear(16) + 0.7152 * linear(8) + 0.0722 * linear(0)) - 16;
}

TEST(colour_maps, grow_evenly_lighter_so_that_lightness_alone_tells_values_apart) {
  const int steps = 16;
  const double whole = lightness(colour_at(MapScale::linear, 1)) - lightness(colour_at(MapScale::linear, 0));
  EXPECT_GT(whole, 60);
  for (int i = 0; i < steps; ++i) {
    const double step = lightness(colour_at(MapScale::linear, (i + 1.0) / steps)) -
                        lightness(colour_at(MapScale::linear, double(i) / steps));
    EXPECT_NEAR(step, whole / steps, 0.4 * whole / steps) << i;
  }
}

TEST(colour_maps, about_a_middle_are_lightest_there_and_darken_to_both_sides) {
  for (int i = 0; i < 8; ++i) {
    EXPECT_LT(lightness(colour_at(MapScale::about_middle, i / 16.0)),
              lightness(colour_at(MapScale::about_middle, (i + 1) / 16.0)));
    EXPECT_LT(lightness(colour_at(MapScale::about_middle, 1 - i / 16.0)),
              lightness(colour_at(MapScale::about_middle, 1 - (i + 1) / 16.0)));
  }
}

TEST(colour_maps, place_values_linearly_by_ratio_or_as_far_on_both_sides_of_the_middle) {
  const ColourMap linear{}, ratio{.scale = MapScale::ratio}, about{.scale = MapScale::about_middle, .middle = 6};
  EXPECT_DOUBLE_EQ(place_on_scale(linear, {2, 6}, 3), 0.25);
  EXPECT_DOUBLE_EQ(place_on_scale(linear, {2, 6}, 9), 1);
  EXPECT_DOUBLE_EQ(place_on_scale(ratio, {1, 100}, 10), 0.5);
  EXPECT_DOUBLE_EQ(place_on_scale(about, {4, 10}, 6), 0.5);
  EXPECT_DOUBLE_EQ(place_on_scale(about, {4, 10}, 4), 0.25);
  EXPECT_DOUBLE_EQ(place_on_scale(linear, {3, 3}, 3), 0.5);
}

TEST(colour_maps, each_speak_of_one_sort_in_both_languages) {
  std::set<std::string_view> ids;
  for (const ColourMap& map : colour_maps()) {
    EXPECT_TRUE(ids.insert(map.id).second) << map.id;
    EXPECT_EQ((map.vertex != nullptr) + (map.edge != nullptr) + (map.face != nullptr) + (map.against != nullptr), 1)
        << map.id;
    for (const std::string_view text : {map.name_en, map.name_ja, map.legend_en, map.legend_ja})
      EXPECT_FALSE(text.empty());
  }
}

TEST(colour_maps, can_be_added_for_a_while) {
  {
    const ScopedColourMap added(
        {.id = "slot", .name_en = "Slot", .name_ja = "番号", .face = [](Neighbourhood&, Face f) {
           return double(f.index);
         }});
    EXPECT_TRUE(find_colour_map("slot"));
  }
  EXPECT_FALSE(find_colour_map("slot"));
}

}  // namespace
}  // namespace ryosen
