// A picture that is drawn in parts: thinned while the camera moves, in slices behind it, refined where it rests.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/renderer.h"
#include "tests/support/core/long_run.h"
#include "tests/support/render/scene.h"

namespace ryosen {
namespace {

// The share of the pixels that show the surface, in each cell of a grid amid the ball.
std::vector<double> covered(const Image& picture, const Image& whole, const Image& empty) {
  constexpr int cell = 20;
  std::vector<double> shares;
  for (int y = 60; y < 140; y += cell)
    for (int x = 60; x < 140; x += cell) {
      int seen = 0, all = 0;
      for (int dy = 0; dy < cell; ++dy)
        for (int dx = 0; dx < cell; ++dx) {
          all += whole.at(x + dx, y + dy) != empty.at(x + dx, y + dy);
          seen += picture.at(x + dx, y + dy) != empty.at(x + dx, y + dy);
        }
      shares.push_back(double(seen) / all);
    }
  return shares;
}

TEST(view, triangles_are_counted_for_the_camera_that_comes_next) {
  const Scene ball = sphere_scene(80);
  const auto view = front_view(ball, {200, 200}, 2.4);
  EXPECT_EQ(view->triangles_in_view(), ball.triangles.size()) << "before anything was drawn";
  view->draw();
  Camera near = view->camera();
  near.eye = near.target + 0.02 * (near.eye - near.target);
  if (near.ortho_height) near.ortho_height = 0.02 * *near.ortho_height;
  view->set_camera(near);
  const std::size_t seen = view->triangles_in_view();
  EXPECT_LT(seen, ball.triangles.size() / 2);
  view->draw();
  EXPECT_EQ(view->triangles_drawn(), seen);
  EXPECT_TRUE(view->is_drawn());
}

TEST(view, a_thinned_surface_is_even_and_its_rest_comes_in_slices_that_make_the_whole) {
  const Scene ball = sphere_scene(80);
  const auto view = front_view(ball, {200, 200}, 2.4);
  view->draw();
  const Image whole = view->read_pixels();
  const auto nothing = front_view(Scene(), {200, 200}, 2.4);
  nothing->draw();
  const Image empty = nothing->read_pixels();
  const std::size_t all = view->triangles_in_view();
  EXPECT_EQ(all, ball.triangles.size());
  view->set_thinning(4);
  view->draw();
  EXPECT_EQ(view->triangles_drawn(), all / 4);
  const Image thinned = view->read_pixels();
  EXPECT_FALSE(thinned == whole);
  for (const double share : covered(thinned, whole, empty)) {
    EXPECT_GT(share, 0.2);
    EXPECT_LT(share, 0.8);
  }
  view->set_thinning(1);
  view->set_most_triangles(6000);
  int slices = 0;
  for (; !view->is_drawn() && slices < 100; ++slices) {
    view->draw();
    EXPECT_LE(view->triangles_drawn(), 6000u);
  }
  EXPECT_GT(slices, 4);
  EXPECT_TRUE(view->read_pixels() == whole);
}

// What changes while a part waits is in the picture at the end.
TEST(view, slices_follow_what_changes_between_them) {
  Scene ball = sphere_scene(40);
  const auto view = front_view(ball, {200, 200}, 2.4);
  view->set_most_triangles(500);
  for (int step = 0; !view->is_drawn(); ++step) {
    ASSERT_LT(step, 200);
    view->draw();
    const auto v = static_cast<std::uint32_t>(400 + 5 * step);
    if (step >= 6) continue;
    ball.positions[v] *= 1.1;
    std::vector<std::uint32_t> touched;
    for (std::uint32_t i = 0; i < ball.triangles.size(); ++i)
      if (std::count(ball.triangles[i].begin(), ball.triangles[i].end(), v) > 0) touched.push_back(i);
    view->update_mesh(ball.source(), {&v, 1}, touched, {});
  }
  const Image followed = view->read_pixels();
  view->draw(PixelRect::all(view->size()));
  EXPECT_TRUE(view->read_pixels() == followed);
}

// Draws on until nothing is left to be refined, and says in how many parts.
int refine(Renderer& view) {
  int parts = 0;
  view.set_refining(true);
  for (; !view.is_refined(); ++parts) view.draw();
  view.set_refining(false);
  return parts;
}

// All that is drawn: tints, patterned lines, points, arrows, ghosts.
std::unique_ptr<Renderer> full_view(Scene& scene, Size size, Xray xray) {
  for (std::size_t f = 0; f < scene.tints.size(); ++f)
    scene.tints[f] = std::array<std::uint8_t, 5>{0, 1, 2, 3, 0}[f % 5];
  auto view = front_view(scene, size, 2.4);
  ViewSettings settings;
  settings.xray = xray;
  view->set_settings(settings);
  constexpr DrawnTint three[] = {{rgb(0xE69F00), {FacePattern::diagonal, 0.75f}},
                                 {rgb(0xF0E442), {FacePattern::plain, 0.55f}},
                                 {rgb(0xBBBBBB), {FacePattern::chessboard, 0.8f}}};
  view->set_tints(three);
  Overlay overlay;
  for (std::size_t i = 0; i + 2 < scene.positions.size(); i += 7) {
    overlay.lines.push_back({1.01 * scene.positions[i], 1.01 * scene.positions[i + 1], rgb(0xE69F00),
                             static_cast<LineStyle>(i % 4), 3.5f, faintly, i % 3 == 0});
    overlay.points.push_back({scene.positions[i + 2], rgb(0x56B4E9), static_cast<PointShape>(i % 5), 6});
  }
  view->set_overlay(Layer::highlights, overlay);
  return view;
}

// The oracle draws the whole picture at four times its size.
TEST(view, refined_is_the_picture_with_several_samples) {
  for (const Xray xray : {Xray::off, Xray::on})
    for (const Size size : {Size{300, 213}, Size{128, 256}}) {
      if ((xray == Xray::on) != (size.width == 128) && !test::is_long_run()) continue;
      Scene ball = sphere_scene(16);
      const auto view = full_view(ball, size, xray);
      Camera camera;
      camera.eye = {0.7, 0.9, 3.4};
      view->set_camera(camera);
      view->draw();
      const Image plain = view->read_pixels();
      EXPECT_EQ(refine(*view), (size.width + 127) / 128 * ((size.height + 127) / 128));
      const Image refined = view->read_pixels();
      EXPECT_GT(compare(plain, refined)->pixels, 1000u);
      view->resize(size, Refinement::samples);
      view->draw();
      EXPECT_TRUE(view->is_refined());
      EXPECT_EQ(compare(view->read_pixels(), refined)->pixels, 0u) << "but for the rounding of places";
      view->resize(size, 2);
      view->draw();
      EXPECT_FALSE(view->is_refined()) << "with fewer samples there is something to refine";
      refine(*view);
      EXPECT_TRUE(view->read_pixels() == refined);
    }
}

// What is made before has left nothing in the picture.
TEST(view, prepared_refining_shows_nothing_else) {
  Scene ball = sphere_scene(16);
  const auto view = full_view(ball, {300, 213}, Xray::off);
  view->draw();
  const Image plain = view->read_pixels();
  view->prepare_refining();
  EXPECT_FALSE(view->is_drawn());
  view->draw();
  EXPECT_FALSE(view->is_refined());
  EXPECT_TRUE(view->read_pixels() == plain);
}

TEST(view, is_refined_in_parts_of_no_more_effort_than_they_may_take) {
  Scene ball = sphere_scene(60);
  const auto view = full_view(ball, {320, 240}, Xray::off);
  Overlay dense;
  for (const auto& t : ball.triangles)
    dense.lines.push_back(
        {ball.positions[t[0]], ball.positions[t[1]], rgb(0xE69F00), LineStyle::solid, 3, 0, false, true});
  view->set_overlay(Layer::selection, dense);
  view->draw();
  const int tiles = refine(*view);
  const Image at_once = view->read_pixels();
  int fewer = tiles;
  for (const double most : {6e6, 3e6}) {
    if (most > 3e6 && !test::is_long_run()) continue;
    view->draw(PixelRect::all(view->size()));
    view->set_most_refining(most);
    view->set_refining(true);
    int parts = 0;
    for (; !view->is_refined(); ++parts) {
      view->draw();
      EXPECT_LE(view->refining_effort(), most);
      EXPECT_GT(view->refining_effort(), 0);
    }
    view->set_refining(false);
    EXPECT_GT(parts, fewer) << most;
    fewer = parts;
    EXPECT_TRUE(view->read_pixels() == at_once) << most;
  }
}

TEST(view, a_part_that_changed_is_refined_as_the_whole_is) {
  Scene ball = sphere_scene(40);
  const auto view = full_view(ball, {320, 240}, Xray::off);
  refine(*view);
  const Image before = view->read_pixels();
  std::mt19937 random(7);
  const auto any = [&](std::size_t below) { return static_cast<std::uint32_t>(random() % below); };
  for (int step = 0; step < (test::is_long_run() ? 12 : 6); ++step) {
    view->draw();
    Overlay overlay;
    overlay.points.push_back({ball.positions[any(ball.positions.size())], rgb(0xF0E442), PointShape::disc, 6});
    view->set_overlay(Layer::hover, overlay);
    if (step % 3 == 2) view->set_most_triangles(any(2) == 0 ? 0 : 900);
    EXPECT_FALSE(view->is_refined());
    view->draw();
    view->set_refining(true);
    for (std::uint32_t part = any(4); part > 0; --part) view->draw();  // interrupted by the next step
    view->set_refining(false);
  }
  view->set_overlay(Layer::hover, {});
  refine(*view);
  EXPECT_TRUE(view->read_pixels() == before);
}

}  // namespace
}  // namespace ryosen
