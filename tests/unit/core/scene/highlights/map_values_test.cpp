#include "ryosen/scene/highlights/map_values.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "ryosen/geometry/is_finite.h"
#include "tests/support/core/element_values.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

constexpr double missing_value = std::numeric_limits<double>::quiet_NaN();

bool same_values(const MapValues& a, const MapValues& b) {
  if (a.all().size() != b.all().size()) return false;
  for (std::uint32_t i = 0; i < a.all().size(); ++i)
    if (a.of(i) != b.of(i) && !(std::isnan(a.of(i)) && std::isnan(b.of(i)))) return false;
  return true;
}

TEST(map_values, figures_leave_out_what_is_not_finite) {
  const double infinite = std::numeric_limits<double>::infinity();
  const MapFigures figures = figures_of(std::array{5.0, missing_value, 1.0, infinite, 3.0, 2.0, 4.0});
  EXPECT_EQ(figures.count, 5u);
  EXPECT_EQ(figures.lowest, 1);
  EXPECT_EQ(figures.lowest_at, 2u);
  EXPECT_EQ(figures.highest, 5);
  EXPECT_EQ(figures.highest_at, 0u);
  EXPECT_EQ(figures.mean, 3);
  EXPECT_EQ(figures.median, 3);
  EXPECT_EQ(figures.quartile_1, 2);
  EXPECT_EQ(figures.quartile_3, 4);
  EXPECT_DOUBLE_EQ(figures.percentile_5, 1.2);
  EXPECT_EQ(figures_of(std::array{missing_value}).count, 0u);
}

TEST(map_values, a_histogram_counts_each_value_once_and_the_end_of_the_range_too) {
  const std::array values{0.0, 0.9, 1.0, 1.5, 3.9, 4.0, 4.1, -0.1, missing_value};
  EXPECT_EQ(histogram(values, {0, 4}, 4), (std::vector<std::uint32_t>{2, 2, 0, 2}));
  EXPECT_EQ(histogram(values, {1, 1}, 3), (std::vector<std::uint32_t>{1, 0, 0}));
}

TEST(map_values, of_a_cube_are_what_one_counts) {
  const Mesh cube_mesh = make_mesh(cube());
  const auto all_are = [&](const char* id, double value) {
    const MapFigures figures = figures_of(MapValues(cube_mesh, *find_colour_map(id)).all());
    EXPECT_EQ(figures.lowest, value) << id;
    EXPECT_EQ(figures.highest, value) << id;
    return figures.count;
  };
  EXPECT_EQ(all_are("valence", 3), 8u);
  EXPECT_EQ(all_are("sides", 4), 6u);
}

// Random edits, undos and redos: after each the values are those of asking anew, and what is listed leads there.
void follow_edits(Mesh mesh, const ColourMap& map, std::uint64_t seed, int& edits) {
  Dice dice(seed);
  Journal journal;
  MapValues values(mesh, map);
  for (int step = 0; step < 12; ++step) {
    const auto transaction = random_step(mesh, journal, dice, 5, [&](int thrown) {
      return thrown == 2 ? edit_at_random(mesh, journal, dice) : try_apply(mesh, &journal, random_op(mesh, dice));
    });
    if (!transaction) continue;
    ++edits;
    std::vector<double> listed(values.all().begin(), values.all().end());
    const auto changed = values.update(mesh, journal, *transaction);
    ASSERT_TRUE(same_values(values, MapValues(mesh, map))) << map.id << " seed " << seed << " step " << step;
    if (!changed) continue;
    listed.resize(values.all().size(), missing_value);
    for (const std::uint32_t i : *changed) listed[i] = values.of(i);
    for (std::uint32_t i = 0; i < listed.size(); ++i)
      ASSERT_TRUE(listed[i] == values.of(i) || (std::isnan(listed[i]) && std::isnan(values.of(i))))
          << map.id << " " << i;
  }
}

TEST(map_values, follow_edits_undo_and_redo) {
  int edits = 0;
  const std::uint64_t seeds = seed_count(25, 60);
  for (const ColourMap& map : colour_maps())
    for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed)
      follow_edits(random_complex(seed), map, seed, edits);
  EXPECT_GT(edits, 17 * static_cast<int>(seeds));
}

TEST(map_values, of_attributes_follow_edits_undo_and_redo) {
  int edits = 0;
  const std::uint64_t seeds = seed_count(25, 200);
  for (const char* name : {"vertex.mean", "vertex.top", "edge.length", "edge.count", "corner.mean", "face.area"})
    for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
      Mesh mesh = random_complex(seed);
      add_values(mesh, nullptr);
      follow_edits(std::move(mesh), *find_colour_map(name), seed, edits);
    }
  EXPECT_GT(edits, 17 * static_cast<int>(seeds));
}

TEST(map_values, are_the_same_for_any_number_of_threads) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Mesh mesh = random_complex(seed);
    for (const ColourMap& map : colour_maps())
      EXPECT_TRUE(same_values(MapValues(mesh, map, 1), MapValues(mesh, map, 3))) << seed << " " << map.id;
  }
}

TEST(map_values, show_the_middle_nine_tenths_first) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i);
  values.push_back(1e6);
  values.push_back(std::nan(""));
  const MapFigures figures = figures_of(values);
  const ColourMap linear{.scale = MapScale::linear}, middle{.scale = MapScale::about_middle, .middle = 50};
  EXPECT_NEAR(first_range(linear, figures).low, 5, 0.1);
  EXPECT_NEAR(first_range(linear, figures).high, 96, 0.1);
  EXPECT_EQ(whole_range(linear, figures), (MapRange{0, 1e6}));
  EXPECT_NEAR(first_range(middle, figures).low, 4, 0.1);  // as far as to the other end
  EXPECT_EQ(extent_of(values), (MapRange{0, 1e6}));
  EXPECT_EQ(extent_of(std::vector<double>{std::nan("")}), std::nullopt);
  const MapFigures near = figures_of(std::vector<double>{1, 1.001, 2, 3, 4, 4.001});
  EXPECT_EQ(first_range(linear, near), (MapRange{1, 4.001})) << "what is left out is not worth it";
  const MapFigures equal = figures_of(std::vector<double>(50, 7.0));
  EXPECT_EQ(first_range(linear, equal), (MapRange{7, 7}));
}

// On both sides alike a map of valences would end below 0.
TEST(map_values, of_counts_are_shown_as_far_as_there_are_any) {
  const ColourMap& valence = *find_colour_map("valence");
  std::vector<double> values(200, 4.0);
  values.push_back(16);
  EXPECT_EQ(whole_range(valence, figures_of(values)), (MapRange{4, 16}));
  for (int i = 0; i < 50; ++i) values.push_back(16);
  EXPECT_EQ(first_range(valence, figures_of(values)), (MapRange{4, 16}));
  EXPECT_EQ(place_on_scale(valence, {4, 16}, 6), 0.5);
  EXPECT_EQ(place_on_scale(valence, {4, 16}, 16), 1);
  EXPECT_EQ(place_on_scale(valence, {4, 16}, 4), 0.4);
}

TEST(map_values, count_what_lies_outside_nowhere_or_at_the_ends) {
  const std::vector<double> values{-5, 0, 1, 2, 3, 4, 9, std::nan("")};
  EXPECT_EQ(histogram(values, {0, 4}, 2), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(histogram(values, {0, 4}, 2, Outside::at_the_ends), (std::vector<std::uint32_t>{3, 4}));
  EXPECT_EQ(histogram(values, {2, 2}, 2, Outside::at_the_ends), (std::vector<std::uint32_t>{4, 3}));
}

TEST(map_values, tell_how_far_they_are_from_their_mean) {
  EXPECT_DOUBLE_EQ(figures_of(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9}).deviation, 2);
  EXPECT_EQ(figures_of(std::vector<double>{}).deviation, 0);
}

}  // namespace
}  // namespace ryosen
