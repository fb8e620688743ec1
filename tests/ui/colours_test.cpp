// The panel of colour maps: its histogram is a tool to select with.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

class ColoursPanelTest : public testing::Test, public Laid {
 public:
  ColoursPanelTest() : Laid("cube.obj", tall_window) {
    for (const PanelRow& row : panel_list())
      if (row.place == PanelPlace::right) session.run("panel " + std::string(row.id) + " off");
    EXPECT_TRUE(session.run("poke f0").done());
    EXPECT_TRUE(session.run("colours area").done());
    frames(4);
  }
  // From one share of the right column's width to another, at a height.
  void drag(double from, double to, double y) {
    const auto at = [&](double share) { return glm::dvec2(1003 + share * 267, y); };
    gui.pointer(at(from));
    frames(2);
    gui.button(0, true);
    frames(2);
    gui.pointer(at(to));
    frames(2);
    gui.button(0, false);
    frames(3);
  }
};

TEST_F(ColoursPanelTest, a_drag_over_the_histogram_selects_what_lies_in_its_range) {
  constexpr double in_histogram = 110;
  drag(0.0, 0.4, in_histogram);
  EXPECT_EQ(session.selecting.selected_names().size(), 4u) << "the four triangles of a quarter each";
  drag(1.0, 0.4, in_histogram);
  EXPECT_EQ(session.selecting.selected_names().size(), 5u) << "backwards; the squares of area 1, the highest value";
  drag(0.0, 1.0, in_histogram);
  EXPECT_EQ(session.selecting.selected_names().size(), 9u);
  for (const Element& e : session.selecting.selection) EXPECT_EQ(e.kind, Element::Kind::face);
  drag(0.3, 0.6, in_histogram);
  EXPECT_TRUE(session.selecting.selection.empty()) << "nothing lies between";
}

TEST_F(ColoursPanelTest, a_map_of_counts_has_a_bar_for_each_value) {
  ASSERT_TRUE(session.run("colours valence").done());
  frames(4);
  drag(0.3, 0.3, 110);
  EXPECT_EQ(session.log().size(), 1u) << "only the poke";
  EXPECT_EQ(session.selecting.selected_names().size(), 4u) << "of three edges: those that the poke leaves";
  drag(0.8, 0.8, 110);
  EXPECT_EQ(session.selecting.selected_names().size(), 5u);
  drag(0.8, 0.3, 110);
  EXPECT_EQ(session.selecting.selected_names().size(), 9u);
  EXPECT_EQ(DrawnText(gui).count("3.0"), 0u);
}

TEST_F(ColoursPanelTest, each_measurement_names_what_was_measured) {
  ASSERT_TRUE(session.run("colours off").done());
  ASSERT_TRUE(session.run("measure v0 v1").done());
  ASSERT_TRUE(session.run("measure 1-2").done());
  frames(4);
  const DrawnText drawn(gui);
  EXPECT_EQ(drawn.count("v0v1distance1"), 1u);
  EXPECT_EQ(drawn.count("1-2length1"), 1u);
}

// The darkest and the brightest pixel amid a picture, as sums of the three.
std::pair<int, int> lights_amid(const Image& picture) {
  int darkest = 765, brightest = 0;
  for (int y = 100; y < 140; ++y)
    for (int x = 140; x < 180; ++x) {
      const Rgba& pixel = picture.at(x, y);
      const int light = pixel[0] + pixel[1] + pixel[2];
      darkest = std::min(darkest, light);
      brightest = std::max(brightest, light);
    }
  return {darkest, brightest};
}

// At both ends of a map: one of them is hardly told from the colour of what is selected.
TEST(selected_faces, are_striped_where_the_surface_has_colours) {
  const auto headless = Headless::make({.backend = Backend::osmesa, .size = {320, 240}}).value();
  Session session(std::move(Document::open(asset("cube.obj")).value()));
  headless->place_view(session);
  const auto lights = [&](std::initializer_list<const char*> lines) {
    for (const char* const line : lines) EXPECT_TRUE(session.run(line).done()) << line;
    return lights_amid(headless->picture(session));
  };
  for (const char* const map : {"colours area 0 1", "colours area 1 2"}) {
    const auto [dark, bright] = lights({"view front", map, "select none"});
    EXPECT_LT(bright - dark, 12) << "a face of one colour";
    const auto [stripe, between] = lights({"select f1"});
    EXPECT_GT(between - stripe, 200) << map;
    const auto [plain, plain_too] = lights({"colours off"});
    EXPECT_LT(plain_too - plain, 12) << "selected alone, it is filled";
  }
}

}  // namespace
}  // namespace ryosen::test
