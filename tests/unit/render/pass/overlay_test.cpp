#include "render/pass/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "tests/support/core/long_run.h"
#include "tests/support/render/scene.h"

namespace ryosen {
namespace {

constexpr Size overlay_size{320, 240};

class Parts {
 public:
  explicit Parts(unsigned seed) : random_(seed) {}

  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  glm::dvec3 place() { return {coordinate(), coordinate(), 0.2 * coordinate()}; }
  // Up to `most` elements of each kind, translucent ones too, so that their order is seen.
  Overlay some(std::uint32_t most) {
    Overlay overlay;
    const auto colour = [&] { return rgb(below(0x1000000), 120); };
    for (std::uint32_t i = below(most); i > 0; --i) {
      overlay.lines.push_back({place(), place(), colour()});
      overlay.lines.back().thins_out = below(2) == 0;
    }
    for (std::uint32_t i = below(most); i > 0; --i) overlay.points.push_back({place(), colour()});
    for (std::uint32_t i = below(most / 4); i > 0; --i)
      overlay.ghosts.push_back({{place(), place(), place()}, colour()});
    return overlay;
  }

 private:
  double coordinate() { return 1.6 * (static_cast<double>(random_() % 10000) / 10000.0 - 0.5); }
  std::mt19937 random_;
};

Overlay joined(const std::map<std::uint32_t, Overlay>& parts) {
  Overlay all;
  for (const auto& [number, part] : parts) {
    all.ghosts.insert(all.ghosts.end(), part.ghosts.begin(), part.ghosts.end());
    all.lines.insert(all.lines.end(), part.lines.begin(), part.lines.end());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  }
  return all;
}

// Parts that come, grow, shrink and go, drawn piece by piece and all at once.
void compare(unsigned seed, std::uint32_t most, int steps) {
  const Scene scene = square_scene(2);
  const auto by_parts = front_view(scene, overlay_size, 2.4), at_once = front_view(scene, overlay_size, 2.4);
  Parts dice(seed);
  std::map<std::uint32_t, Overlay> parts;
  for (int step = 0; step < steps; ++step) {
    const std::uint32_t number = 7 * dice.below(12);
    Overlay& part = parts[number];
    if (dice.below(4) == 0) {
      part = {};
    } else if (dice.below(2) == 0 && !part.lines.empty()) {
      part.lines[dice.below(static_cast<std::uint32_t>(part.lines.size()))].b = dice.place();
    } else {
      part = dice.some(most);
    }
    by_parts->set_overlay_part(Layer::highlights, number, part);
    by_parts->draw();
    at_once->set_overlay(Layer::highlights, joined(parts));
    at_once->draw(PixelRect::all(at_once->size()));
    ASSERT_EQ(by_parts->read_pixels(), at_once->read_pixels()) << "seed " << seed << " step " << step;
  }
  by_parts->draw(PixelRect::all(by_parts->size()));
  EXPECT_EQ(by_parts->read_pixels(), at_once->read_pixels());
  by_parts->set_overlay(Layer::highlights, {});
  at_once->set_overlay(Layer::highlights, {});
  by_parts->draw();
  at_once->draw();
  EXPECT_EQ(by_parts->read_pixels(), at_once->read_pixels()) << "the whole replaces all parts";
}

TEST(overlay_parts, look_as_if_drawn_at_once) { compare(1, 12, test::is_long_run() ? 150 : 60); }

TEST(overlay_parts, large_ones_move_within_the_buffer) { compare(2, 1500, test::is_long_run() ? 12 : 6); }

TEST(overlay_parts, only_what_changed_is_drawn_again) {
  const auto view = front_view(square_scene(1), overlay_size, 2.4);
  Overlay left, right;
  left.points.push_back({{-0.5, 0, 0}, rgb(0xFF00FF)});
  right.points.push_back({{0.5, 0, 0}, rgb(0xFF00FF)});
  view->set_overlay_part(Layer::highlights, 3, left);
  view->set_overlay_part(Layer::highlights, 9, right);
  view->draw();
  view->set_overlay_part(Layer::highlights, 3, left);
  EXPECT_TRUE(view->draw().empty());
  left.points[0].at.y = 0.05;
  view->set_overlay_part(Layer::highlights, 3, left);
  const PixelRect rect = view->draw();
  EXPECT_FALSE(rect.empty());
  EXPECT_LT(rect.x1, 160);
}

int coloured(Renderer& view, double length, bool thins_out, LineStyle style = LineStyle::solid) {
  Overlay overlay;
  overlay.lines.push_back({{-0.5 * length, 0, 0}, {0.5 * length, 0, 0}, rgb(0xFF00FF), style, 6});
  overlay.lines[0].thins_out = thins_out;
  view.set_overlay(Layer::highlights, overlay);
  view.draw();
  const Image picture = view.read_pixels();
  return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                        [](const Rgba& p) { return p[0] > 180 && p[1] < 90 && p[2] > 180; }));
}

TEST(overlay, lines_thin_out_where_they_are_short) {
  const auto view = front_view(square_scene(1), overlay_size, 2.4);
  EXPECT_EQ(coloured(*view, 1, true), coloured(*view, 1, false)) << "a long line is as wide as ever";
  EXPECT_EQ(coloured(*view, 1, true, LineStyle::dotted), coloured(*view, 1, false, LineStyle::dotted))
      << "and as styled";
  const int thin = coloured(*view, 0.08, true);
  EXPECT_GT(thin, 5);
  EXPECT_LT(2 * thin, coloured(*view, 0.08, false)) << "one of 8 pixels is not";
}

// The border of an arrow is as wide before its tip and beside its head as beside its shaft: nothing looks like a second
// one.
TEST(overlay, the_rim_of_an_arrow_lies_all_round_it) {
  const auto view = front_view(square_scene(1), overlay_size, 2.4);
  Overlay overlay;
  overlay.lines.push_back({{-0.5, 0, 0}, {0.5, 0, 0}, rgb(0x00FF00), LineStyle::solid, 4, 0, true, false, true});
  overlay.lines.push_back({{-0.5, 0, 0}, {0.5, 0, 0}, rgb(0xFF00FF), LineStyle::solid, 4, 0, true});
  view->set_overlay(Layer::highlights, overlay);
  view->draw();
  const Image picture = view->read_pixels();
  const auto width = static_cast<std::size_t>(overlay_size.width);
  const auto at = [&](std::size_t x, std::size_t y) { return picture.pixels[y * width + x]; };
  const auto is_arrow = [&](int x, int y) { return at(x, y)[0] > 128 && at(x, y)[1] < 128; };
  const auto is_rim = [&](int x, int y) { return at(x, y)[0] < 128 && at(x, y)[1] > 150 && at(x, y)[2] < 128; };
  int columns = 0, across = 0, lopsided = 0;  // across: where it is cut across behind the head
  for (int x = 0; x < overlay_size.width; ++x) {
    int above = 0, below = 0, within = 0;
    for (int y = 0; y < overlay_size.height; ++y) {
      within += is_arrow(x, y);
      (y < overlay_size.height / 2 ? above : below) += is_rim(x, y);
    }
    if (within == 0) continue;
    ++columns;
    across += std::max(above, below) > 4;
    lopsided += std::abs(above - below) > 1;
  }
  EXPECT_GT(columns, 80);
  EXPECT_LE(across, 3) << "behind the head it is no wider than elsewhere";
  EXPECT_EQ(lopsided, 0);
  int before_tip = 0;
  for (int x = overlay_size.width / 2; x < overlay_size.width; ++x) before_tip += is_rim(x, overlay_size.height / 2);
  EXPECT_GE(before_tip, 1) << "before the tip";
  EXPECT_LE(before_tip, 4);
}

TEST(overlay, of_many_lines_that_thin_out_a_part_is_drawn_while_the_surface_is_thinned) {
  const auto view = front_view(square_scene(1), overlay_size, 2.4);
  Overlay overlay;
  for (int i = 0; i < 100000; ++i) {
    const double y = i * 1e-5 - 0.5;
    overlay.lines.push_back({{-0.5, y, 0}, {-0.49, y, 0}, rgb(0xFF00FF, 8)});
    overlay.lines.back().thins_out = true;
  }
  view->set_overlay(Layer::highlights, overlay);
  view->draw();
  const Image whole = view->read_pixels();
  view->set_thinning(2);
  view->draw();
  EXPECT_NE(view->read_pixels(), whole);
  view->set_thinning(1);
  view->draw();
  EXPECT_EQ(view->read_pixels(), whole) << "at rest all are there";
}

}  // namespace
}  // namespace ryosen
