#include "app/editor/texts/measure_text.h"

#include <gtest/gtest.h>

#include <array>

#include "ryosen/mesh/circulate.h"
#include "ryosen/scene/highlights/colour_maps.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using Texts = std::vector<std::string>;

TEST(numbers_alike, have_as_many_digits_as_tell_them_apart) {
  EXPECT_EQ(numbers_alike(std::array{1.28117766, 1.29241401}), (Texts{"1.28118", "1.29241"}));
  EXPECT_EQ(numbers_alike(std::array{0.0, 90.0, 180.0}), (Texts{"0", "90", "180"}));
  EXPECT_EQ(numbers_alike(std::array{0.25, 0.5, 1.0}), (Texts{"0.25", "0.50", "1.00"}));
  EXPECT_EQ(numbers_alike(std::array{-1.5, 0.0, 1.5}), (Texts{"-1.5", "0.0", "1.5"}));
}

TEST(numbers_alike, have_one_notation) {
  EXPECT_EQ(numbers_alike(std::array{9.419e-05, 1.2559e-04, 0.000157}), (Texts{"0.9419e-4", "1.2559e-4", "1.5700e-4"}));
  EXPECT_EQ(numbers_alike(std::array{0.0, 5e-9}), (Texts{"0", "5e-9"}));
  EXPECT_EQ(numbers_alike(std::array{2e7, 3e7}), (Texts{"2e7", "3e7"}));
}

TEST(numbers_alike, are_told_whole_where_they_are_one) {
  EXPECT_EQ(numbers_alike(std::array{0.125, 0.125}), (Texts{"0.125", "0.125"}));
  EXPECT_TRUE(numbers_alike({}).empty());
}

TEST(short_text_of, a_map_has_one_notation_for_all_its_figures) {
  const MapFigures figures{.count = 9, .lowest = 0.25, .highest = 1, .mean = 2.0 / 3, .median = 1};
  const std::string text = short_text_of(*find_colour_map("edge_length"), figures).en;
  EXPECT_NE(text.find(": 0.2500 to 1.0000, mean 0.6667, median 1.0000, of 9"), std::string::npos) << text;
}

TEST(legend_values, of_counts_are_whole_and_each_is_there_once) {
  const ColourMap &counts = *find_colour_map("valence"), &lengths = *find_colour_map("edge_length");
  using Values = std::vector<double>;
  EXPECT_EQ(legend_values(lengths, {3, 6}, 3), (Values{3, 4.5, 6}));
  EXPECT_EQ(legend_values(lengths, {3, 3}, 7), (Values{3}));
  EXPECT_EQ(legend_values(counts, {3, 6}, 7), (Values{3, 4, 5, 6}));
  EXPECT_EQ(legend_values(counts, {3, 6}, 3), (Values{3, 5, 6}));
  EXPECT_EQ(legend_values(counts, {3, 103}, 3), (Values{3, 53, 103}));
  EXPECT_EQ(legend_values(counts, {2.5, 4.75}, 7), (Values{3, 4})) << "within a range that was typed";
  EXPECT_EQ(legend_values(counts, {4, 4}, 7), (Values{4}));
  EXPECT_EQ(legend_values(counts, {3.25, 3.75}, 3), (Values{3.25, 3.5, 3.75})) << "there is no whole one";
}

TEST(short_text_of, counts_that_are_whole_have_no_decimals) {
  const MapFigures figures{.count = 9, .lowest = 3, .highest = 9, .mean = 5.98, .median = 6};
  for (const char* id : {"valence", "sides"}) {
    const std::string text = short_text_of(*find_colour_map(id), figures).en;
    EXPECT_NE(text.find(": 3 to 9, mean 5.98, median 6, of 9"), std::string::npos) << text;
  }
}

TEST(names_of_measured, are_those_of_the_kernel_and_of_many_the_first) {
  const Mesh mesh = test::make_mesh(test::cube());
  const std::vector<Element> few{Vertex(1), find_halfedge(mesh, Vertex(1), Vertex(0)), Face(3)};
  EXPECT_EQ(names_of_measured(mesh, few), "v1 1-0 f3");
  std::vector<Element> many(few);
  many.resize(12, Face(0));
  EXPECT_EQ(names_of_measured(mesh, many), "v1 1-0 f3 +9");
}

}  // namespace
}  // namespace ryosen
