// What helps to see a mesh: the ground grid, the axes in the corner, the clipping plane, and sizes by the display.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class ViewAidsTest : public testing::Test {
 protected:
  ViewAidsTest() { open("torus.off", {640, 480}); }
  void open(const std::string& name, Size size) {
    session_ = std::make_unique<Session>(Document::open(test::asset(name)).value());
    headless_.reset();  // its context ends before the next one is made
    headless_ = Headless::make({.backend = Backend::osmesa, .size = size}).value();
    headless_->place_view(*session_);
  }
  Image picture(const std::string& line) {
    const Outcome outcome = session_->run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
    return headless_->picture(*session_);
  }
  void expect_followed(const std::string& line) {
    const Image followed = picture(line);
    EXPECT_TRUE(followed == headless_->view_drawn_again()) << line;
  }
  static int different(const Image& a, const Image& b, const PixelRect& part) {
    int count = 0;
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x) count += a.at(x, y) != b.at(x, y);
    return count;
  }

  std::unique_ptr<Session> session_;
  std::unique_ptr<Headless> headless_;
};

constexpr PixelRect whole{0, 0, 640, 480};

TEST_F(ViewAidsTest, the_grid_lies_below_the_mesh_and_fades) {
  const Image bare = picture("view iso"), grid = picture("ground on");
  EXPECT_GT(different(bare, grid, whole), 3000);
  EXPECT_EQ(different(bare, grid, {0, 0, 40, 40}), 0) << "not as far as that";
  // From the side it is a line or nothing, and all of it below the middle of the mesh.
  const Image side = picture("view front");
  EXPECT_EQ(different(picture("ground off"), side, {0, 0, 640, 240}), 0);
  for (const char* const theme : {"theme light", "theme dark"}) {
    picture("view top");
    const Image without = picture(theme);
    EXPECT_GT(different(picture("ground on"), without, whole), 1000) << theme;
    picture("ground off");
    picture("view front");
  }
}

TEST_F(ViewAidsTest, the_grid_does_not_cover_what_is_above_it) {
  picture("view top");
  const Image bare = picture("ground off"), grid = picture("ground on");
  const glm::dvec3 on_top = [&] {
    glm::dvec3 highest(0, -1e9, 0);
    for (const glm::dvec3& place : session_->mesh().positions())
      if (place.y > highest.y) highest = place;
    return highest;
  }();
  const glm::ivec2 at(project(session_->view.camera, session_->view.size, on_top)->pixel);
  EXPECT_EQ(different(bare, grid, {at.x - 6, at.y - 6, at.x + 6, at.y + 6}), 0);
}

TEST_F(ViewAidsTest, the_grid_follows_the_lowest_of_the_mesh) {
  picture("ground on");
  picture("view iso");
  for (const char* const line :
       {"move_vertex v0 0,-3,0", "translate by=0,1,0", "undo", "undo", "shading smooth", "xray on", "xray off"})
    expect_followed(line);
}

TEST_F(ViewAidsTest, the_axes_stand_in_the_corner_over_everything) {
  const Image bare = picture("view iso"), axes = picture("axes on");
  EXPECT_GT(different(bare, axes, {520, 0, 640, 120}), 500);
  EXPECT_EQ(different(bare, axes, {0, 120, 640, 480}), 0);
  EXPECT_EQ(different(bare, axes, {0, 0, 520, 480}), 0);
  // Also where the mesh is behind or in front of them.
  picture(R"(camera {"eye":[0,0,0.5],"target":[0.1,0,-3],"up":[0,1,0],"ortho_height":null})");
  const Image near = picture("axes off");
  EXPECT_GT(different(near, picture("axes on"), {520, 0, 640, 120}), 500);
  for (const char* const line : {"projection orthographic", "view top", "move_vertex v0 0,3,0", "theme light"})
    expect_followed(line);
  expect_followed("axes off");
}

TEST_F(ViewAidsTest, the_cut_shows_what_is_inside_and_its_line) {
  const Image closed = picture("view iso"), open = picture("clip view");
  EXPECT_GT(different(closed, open, whole), 5000);
  const Rgba line = palette(Theme::dark).cut;
  const auto of_line = [&](const Image& image) {
    return std::count_if(image.pixels.begin(), image.pixels.end(), [&](const Rgba& p) {
      return std::abs(p[0] - line[0]) + std::abs(p[1] - line[1]) + std::abs(p[2] - line[2]) < 6;
    });
  };
  EXPECT_GT(of_line(open), of_line(closed) + 300);
  for (const char* const next : {"clip_at 0.3", "wire off", "shading smooth", "move_vertex v3 0.2,0.4,0.1",
                                 "show all on", "mode vertex", "select all", "xray on", "clip -x", "undo", "xray off"})
    expect_followed(next);
  session_->selecting.selection.clear();
  picture("show all off");
  picture("mode edge");
  picture("wire on");
  picture("shading flat");
  picture("view iso");
  expect_followed("clip off");
}

// What is drawn is what can be picked: a grid of pixels asks both.
TEST_F(ViewAidsTest, what_is_picked_is_what_is_drawn) {
  picture("view iso");
  for (const char* const line : {"clip x", "clip -z", "clip view", "clip_at 0.7"}) {
    picture(line);
    const IdImage ids = headless_->read_ids();
    int compared = 0, same = 0;
    for (int y = 4; y < 480; y += 9)
      for (int x = 4; x < 640; x += 9) {
        const auto picked = session_->pointing.pick({x + 0.5, y + 0.5}, PickMode::face);
        const std::uint32_t drawn = ids.face[static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x)];
        compared += drawn != no_index;
        same += drawn != no_index && picked && picked->face.index == drawn;
        if (drawn == no_index && picked) ++compared;
      }
    EXPECT_GT(compared, 500) << line;
    EXPECT_GT(same, 0.99 * compared) << line;
  }
}

TEST_F(ViewAidsTest, lines_points_and_handles_are_as_much_larger_as_the_display) {
  open("three_tri_edge.off", {400, 400});
  picture("wire off");
  const auto highlighted = [&] {
    const Image with = picture("show all on"), without = picture("show all off");
    return different(with, without, {0, 0, 400, 400});
  };
  const int usual = highlighted();
  picture("prefer scale 2");
  const int large = highlighted();
  EXPECT_GT(large, 1.7 * usual);
  EXPECT_LT(large, 2.4 * usual) << "as long, twice as wide";
  picture("show all on");
  expect_followed("move_vertex v0 0.2,0.3,0.1");
  expect_followed("undo");
}

// A square of so many isolated vertices a side.
std::string dust(int side) {
  std::string text;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      text += "v " + std::to_string((x + 0.5) / side) + " " + std::to_string((y + 0.5) / side) + " 0\n";
  return text;
}

TEST_F(ViewAidsTest, rings_shrink_where_there_are_many) {
  const test::TemporaryFolder folder;
  const auto covered = [&](int side) {
    session_ = std::make_unique<Session>(Document::open(folder.write("dust.obj", dust(side))).value());
    headless_.reset();
    headless_ = Headless::make({.backend = Backend::osmesa, .size = {400, 400}}).value();
    headless_->place_view(*session_);
    picture(R"(camera {"eye":[0.5,0.5,9],"target":[0.5,0.5,0],"up":[0,1,0],"ortho_height":1})");
    const Image with = picture("show isolated on"), without = picture("show isolated off");
    return different(with, without, {0, 0, 400, 400}) / (400.0 * 400);
  };
  const double one = covered(5) / (5 * 5);
  EXPECT_NEAR(covered(9) / (9 * 9), one, 0.1 * one) << "few are as large as others";
  EXPECT_GT(60 * 60 * one, 2) << "as large, so many would cover all of it twice";
  EXPECT_LT(covered(60), 0.8);
  EXPECT_GT(covered(60), 0.1);
  picture("show isolated on");
  for (const char* const line : {"view iso", "view front", "remove_vertex v7", "move_vertex v8 3,3,0", "undo", "undo"})
    expect_followed(line);
}

// How many pixels are another in the one picture, though nothing of the surface lies within `reach` pixels of them.
int different_off_the_surface(const Image& a, const Image& b, const IdImage& ids, int reach) {
  const auto is_near = [&](int x, int y) {
    for (int v = std::max(0, y - reach); v <= std::min(ids.size.height - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(ids.size.width - 1, x + reach); ++u)
        if (ids.face[static_cast<std::size_t>(v) * static_cast<std::size_t>(ids.size.width) +
                     static_cast<std::size_t>(u)] != no_index)
          return true;
    return false;
  };
  int count = 0;
  for (int y = 0; y < ids.size.height; ++y)
    for (int x = 0; x < ids.size.width; ++x) count += a.at(x, y) != b.at(x, y) && !is_near(x, y);
  return count;
}

TEST_F(ViewAidsTest, lines_end_at_the_cut_where_the_surface_does) {
  open("cube.obj", {640, 480});
  picture(R"(camera {"eye":[1.9,1.4,1.6],"target":[0.5,0.5,0.5],"up":[0,0,1]})");
  for (const char* const cut : {"clip x", "clip -y", "clip z"}) {
    const Image surface = picture(cut);
    const IdImage ids = headless_->read_ids();
    const Image arrows = picture("links all");
    EXPECT_GT(different(surface, arrows, whole), 500) << cut;
    EXPECT_EQ(different_off_the_surface(surface, arrows, ids, 9), 0) << cut;
    picture("links off");
  }
}

}  // namespace
}  // namespace ryosen
