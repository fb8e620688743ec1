// A view of another kind beside the one in space: what is pointed at, selected and edited in either shows in both.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/editor/session/session.h"
#include "app/ui/viewport.h"
#include "render/context/context.h"
#include "tests/support/app/plane_view.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

using test::PlaneView;

std::ptrdiff_t count(const Image& image, Rgba colour) {
  return std::count(image.pixels.begin(), image.pixels.end(), colour);
}

// A net of n x n squares in the plane z = 0, the unit of its coordinates.
std::string net(int n) {
  std::string off = "OFF\n" + std::to_string((n + 1) * (n + 1)) + " " + std::to_string(n * n) + " 0\n";
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) off += std::to_string(x) + " " + std::to_string(y) + " 0\n";
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int v = y * (n + 1) + x;
      for (const int corner : {4, v, v + 1, v + n + 2, v + n + 1}) off += std::to_string(corner) + " ";
      off += "\n";
    }
  return off;
}

class PlaneViewTest : public testing::Test {
 protected:
  static constexpr int n = 8;

  PlaneViewTest() : context_(make_headless_context(Backend::osmesa).value()), viewport_(Viewport::make().value()) {
    session_.place_view({320, 240}, {0, 0});
    session_.run("view front");
    session_.framing.frame_all();
    plane_ = std::make_unique<PlaneView>(session_, glm::dvec2(400, 20), Size{200, 200}, glm::dvec2(-0.5), n + 1);
  }
  ~PlaneViewTest() override { plane_.reset(); }

  Image in_space() {
    viewport_->follow(session_);
    viewport_->draw();
    return viewport_->renderer().read_pixels();
  }
  // The middle of the inner edge between v30 and v31, in either view.
  const glm::dvec2 place_{3.5, 3};
  glm::dvec2 pixel_in_space() const { return project(session_.view.camera, session_.view.size, {place_, 0})->pixel; }
  glm::dvec2 pixel_in_plane() const { return plane_->pixel_of(place_); }

  const test::TemporaryFolder folder_;
  Session session_{Document::open(folder_.write("net.off", net(n))).value()};
  std::unique_ptr<Context> context_;
  std::unique_ptr<Viewport> viewport_;
  std::unique_ptr<PlaneView> plane_;
};

TEST_F(PlaneViewTest, what_is_hovered_in_one_is_marked_in_both) {
  const Image nothing = in_space();
  session_.pointing.point_at(pixel_in_space());
  ASSERT_TRUE(session_.selecting.hover());
  const Element hovered = session_.selecting.hover()->picked.element;
  EXPECT_EQ(hovered.kind, Element::Kind::edge);
  EXPECT_NE(session_.pointing.pointed()->view, plane_.get());
  const Image by_space = in_space();
  EXPECT_NE(by_space, nothing);
  EXPECT_GT(count(plane_->draw(), PlaneView::hovered), 15);
  session_.pointing.point_away();
  EXPECT_EQ(count(plane_->draw(), PlaneView::hovered), 0);
  session_.pointing.point_at(pixel_in_plane());
  ASSERT_TRUE(session_.pointing.pointed());
  EXPECT_EQ(session_.pointing.pointed()->view, plane_.get());
  EXPECT_EQ(session_.pointing.pointed()->document, &session_.document());
  EXPECT_EQ(session_.pointing.pointed()->picked.element, hovered);
  EXPECT_NEAR(session_.pointing.pointed()->picked.place.x, place_.x, 0.05);
  EXPECT_EQ(in_space(), by_space) << "as if it were pointed at in space";
  EXPECT_GT(count(plane_->draw(), PlaneView::hovered), 15);
}

TEST_F(PlaneViewTest, a_click_in_it_selects_for_both) {
  ASSERT_TRUE(session_.pointing.click(pixel_in_space(), "").done());
  ASSERT_EQ(session_.selecting.selection.size(), 1u);
  const Element clicked = session_.selecting.selection.back();
  const Image by_space = in_space();
  EXPECT_GT(count(plane_->draw(), PlaneView::selected), 15);
  session_.run("select none");
  EXPECT_EQ(count(plane_->draw(), PlaneView::selected), 0);
  ASSERT_TRUE(session_.pointing.click(pixel_in_plane(), "").done());
  ASSERT_EQ(session_.selecting.selection.size(), 1u);
  EXPECT_EQ(session_.selecting.selection.back(), clicked);
  EXPECT_EQ(in_space(), by_space);
}

TEST_F(PlaneViewTest, a_tool_shows_its_verdict_and_edits_from_either) {
  session_.run("tool collapse");
  session_.pointing.point_at(pixel_in_plane());
  ASSERT_TRUE(session_.selecting.hover() && session_.selecting.hover()->op);
  EXPECT_TRUE(session_.selecting.hover()->preview.verdict.legal());
  const std::uint32_t edges = session_.mesh().live().edges;
  const std::size_t rebuilds = plane_->rebuilds();
  ASSERT_TRUE(session_.pointing.click(pixel_in_plane(), "collapse").done());
  EXPECT_LT(session_.mesh().live().edges, edges);
  plane_->follow();
  EXPECT_EQ(plane_->rebuilds(), rebuilds) << "it takes what has changed";
  session_.run("undo");
  EXPECT_EQ(session_.mesh().live().edges, edges);
}

TEST_F(PlaneViewTest, what_follows_edits_is_what_is_drawn_anew) {
  std::mt19937 random(3);
  const std::size_t rebuilds = plane_->rebuilds();
  for (int step = 0; step < 200; ++step) {
    const std::uint32_t i = static_cast<std::uint32_t>(random() % session_.mesh().edge_slots());
    const std::string edge = "e" + std::to_string(i);
    const std::string lines[] = {"split " + edge, "swap " + edge, "collapse " + edge, "undo", "redo",
                                 "hide " + edge,  "unhide"};
    session_.run(lines[random() % std::size(lines)]);
    plane_->follow();
    if (step % 20 != 0) continue;
    const PlaneView anew(session_, glm::dvec2(400, 20), Size{200, 200}, glm::dvec2(-0.5), n + 1);
    EXPECT_EQ(plane_->draw(), anew.draw()) << "step " << step;
  }
  EXPECT_LE(plane_->rebuilds(), rebuilds + 10) << "but where more has changed than the feed keeps";
  EXPECT_GT(session_.document().history().size(), 20u);
}

TEST_F(PlaneViewTest, a_movement_by_hand_is_followed_at_each_step) {
  session_.run("select v30");
  ASSERT_TRUE(session_.gesturing.begin(PointTransform::Kind::move).done());
  const Image before = plane_->draw();
  session_.gesturing.follow(session_.view.origin + glm::dvec2(300, 200), {});
  plane_->follow();
  EXPECT_NE(plane_->draw(), before);
  session_.gesturing.give_up();
  plane_->follow();
  EXPECT_EQ(count(plane_->draw(), PlaneView::line), count(before, PlaneView::line));
}

TEST_F(PlaneViewTest, a_verdict_that_is_held_ends_with_it) {
  session_.run("tool swap");
  const glm::dvec2 on_boundary = plane_->pixel_of({3.5, 0});
  ASSERT_EQ(session_.pointing.click(on_boundary, "swap").exit_code, ExitCode::refused);
  ASSERT_TRUE(session_.selecting.is_verdict_held());
  plane_.reset();
  EXPECT_FALSE(session_.selecting.is_verdict_held());
  EXPECT_TRUE(session_.run("move_vertex 0 0,0,1").done());
}

TEST_F(PlaneViewTest, it_hides_handles_that_lie_below_it) {
  session_.run("select v40");
  session_.run("gizmo move");
  ASSERT_TRUE(session_.pointing.gizmo());
  std::optional<glm::dvec2> at;
  for (double y = 0; y < 240 && !at; y += 2)
    for (double x = 0; x < 320 && !at; x += 2)
      if (session_.pointing.handle_at({x, y}, {})) at = glm::dvec2(x, y);
  ASSERT_TRUE(at);
  const PlaneView over(session_, *at - glm::dvec2(10), Size{20, 20}, {0, 0}, n);
  EXPECT_FALSE(session_.pointing.handle_at(*at, {}));
}

TEST_F(PlaneViewTest, nothing_of_it_is_left_where_it_goes) {
  session_.pointing.point_at(pixel_in_plane());
  const glm::dvec2 there = pixel_in_plane();
  plane_.reset();
  EXPECT_FALSE(session_.selecting.hover());
  EXPECT_EQ(session_.pointing.pointed(), nullptr);
  session_.pointing.point_at(there);
  EXPECT_FALSE(session_.selecting.hover()) << "nobody draws anything there";
}

}  // namespace
}  // namespace ryosen
