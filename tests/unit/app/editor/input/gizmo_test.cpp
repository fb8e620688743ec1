#include "app/editor/input/gizmo.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/editor/input/view/view_input.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/snapping.h"
#include "ryosen/algo/transform/moved_points.h"
#include "ryosen/scene/view/named_views.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class GizmoTest : public testing::Test {
 protected:
  GizmoTest() : session_(open()) { run({"gizmo move", "mode vertex", "select v0", "select grow"}); }
  static std::unique_ptr<Session> open() {
    auto document = Document::open(test::asset("torus.off"));
    EXPECT_TRUE(document);
    return std::make_unique<Session>(std::move(document).value());
  }
  void run(std::initializer_list<std::string> lines) {
    for (const std::string& line : lines) {
      const Outcome outcome = session_->run(line);
      EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
    }
  }
  // The middle of what a handle draws, in the picture.
  glm::dvec2 pixel_of(HandleWay way) const {
    const auto gizmo = session_->pointing.gizmo();
    for (const GizmoHandle& handle : gizmo->handles) {
      if (handle.row->way != way) continue;
      const glm::dvec3 place = way == HandleWay::free ? gizmo->middle
                               : handle.plate.empty() ? (handle.strokes[0].a + handle.strokes[0].b) * 0.5
                                                      : (handle.plate[0] + handle.plate[2]) * 0.5;
      return project(session_->view.camera, session_->view.size, place)->pixel + session_->view.origin;
    }
    ADD_FAILURE() << "the handle is not there";
    return {};
  }
  static std::string text(glm::dvec2 pixel) { return std::to_string(pixel.x) + "," + std::to_string(pixel.y); }
  glm::dvec3 middle() const { return session_->pointing.gizmo()->middle; }
  void drag(HandleWay way, glm::dvec2 by, const std::string& modifiers = "") {
    const glm::dvec2 from = pixel_of(way);
    run({"press left " + text(from), "move " + text(from + 0.5 * by) + modifiers, "move " + text(from + by) + modifiers,
         "release left " + text(from + by) + modifiers});
  }

  std::unique_ptr<Session> session_;
};

TEST_F(GizmoTest, a_drag_of_an_arrow_moves_along_its_axis_as_one_command) {
  for (const auto& [way, axis] : {std::pair(HandleWay::x, 0), std::pair(HandleWay::y, 1)}) {
    const glm::dvec3 before = middle();
    const Camera camera = session_->view.camera;
    drag(way, {60, -50});
    const glm::dvec3 moved = middle() - before;
    EXPECT_GT(std::abs(moved[axis]), 1e-3);
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(k == axis || std::abs(moved[k]) < 1e-12) << k << ": " << moved[k];
    EXPECT_EQ(session_->view.camera, camera);
    EXPECT_TRUE(session_->log().back().starts_with("translate by=")) << session_->log().back();
  }
  EXPECT_EQ(session_->document().history().size(), 2u);
}

TEST_F(GizmoTest, is_the_gesture_of_the_keys) {
  const glm::dvec2 from = pixel_of(HandleWay::x);
  drag(HandleWay::x, {60, 0});
  const std::string dragged = session_->log().back();
  run({"undo", "move " + text(from), "key G", "key X", "move " + text(from + glm::dvec2(60, 0)), "key Enter"});
  EXPECT_EQ(session_->log().back(), dragged);
}

TEST_F(GizmoTest, a_plate_moves_in_its_plane) {
  run({"view front"});
  const glm::dvec3 before = middle();
  drag(HandleWay::xy, {40, 30});
  const glm::dvec3 moved = middle() - before;
  EXPECT_GT(std::abs(moved.x), 1e-3);
  EXPECT_GT(std::abs(moved.y), 1e-3);
  EXPECT_NEAR(moved.z, 0, 1e-12);
}

TEST_F(GizmoTest, escape_takes_back_and_a_click_does_nothing) {
  const std::uint64_t hash = session_->mesh().hash();
  const Elements selected = session_->selecting.selection;
  const Camera camera = session_->view.camera;
  const glm::dvec2 from = pixel_of(HandleWay::y);
  run({"press left " + text(from), "move " + text(from + glm::dvec2(50, 20))});
  ASSERT_TRUE(session_->gesturing.is_active());
  run({"key Escape", "move " + text(from + glm::dvec2(90, 20)), "release left " + text(from + glm::dvec2(90, 20))});
  EXPECT_FALSE(session_->gesturing.is_active());
  drag(HandleWay::y, {1, 1});
  EXPECT_EQ(session_->mesh().hash(), hash);
  EXPECT_TRUE(session_->document().history().empty());
  EXPECT_EQ(session_->selecting.selection, selected);
  EXPECT_EQ(session_->view.camera, camera);
}

// The neighbours of what was clicked mostly lie under the handles that come there with it.
TEST_F(GizmoTest, a_click_goes_through_to_what_lies_under_a_handle_where_no_more_than_one_is_selected) {
  const auto click = [&](glm::dvec2 at, const std::string& modifiers = "") {
    run({"press left " + text(at) + modifiers, "release left " + text(at) + modifiers});
  };
  run({"mode face", "select f20"});
  std::optional<Element> below;
  glm::dvec2 at{0};
  const auto gizmo = session_->pointing.gizmo();
  for (const GizmoHandle& handle : gizmo->handles) {
    if (handle.strokes.empty() || handle.row->way == HandleWay::free) continue;
    const auto seen = project(session_->view.camera, session_->view.size, handle.strokes[0].b);
    at = seen->pixel + session_->view.origin;
    const auto picked = session_->pointing.pick(at, PickMode::face);
    if (picked && picked->element != Element(Face(20))) below = picked->element;
    if (below) break;
  }
  ASSERT_TRUE(below) << "no handle lies before another face";
  ASSERT_TRUE(session_->pointing.handle_at(at, {}));
  click(at);
  EXPECT_EQ(session_->selecting.selection, Elements{*below});

  run({"select f20 f21"});
  const Elements both = session_->selecting.selection;
  const glm::dvec2 over = pixel_of(HandleWay::y);
  click(over);
  EXPECT_EQ(session_->selecting.selection, both) << "a selection of several is not lost by a touch";
  EXPECT_TRUE(session_->document().history().empty());
}

TEST_F(GizmoTest, a_double_click_makes_the_centre_though_the_first_brings_handles_there) {
  run({"mode face", "select f20"});
  const auto seen = session_->pointing.pick(pixel_of(HandleWay::free), PickMode::face);
  ASSERT_TRUE(seen);
  session_->selecting.selection = Elements{seen->element};
  const glm::dvec2 at = pixel_of(HandleWay::free) + glm::dvec2(10, 0);  // on the ring of the handle across the view
  const auto picked = session_->pointing.pick(at, PickMode::face);
  ASSERT_TRUE(picked);
  run({"select none", "press left " + text(at), "release left " + text(at)});
  EXPECT_EQ(session_->selecting.selection, Elements{picked->element});
  ASSERT_TRUE(session_->pointing.handle_at(at, {}));
  run({"press left " + text(at), "release left " + text(at)});
  EXPECT_NEAR(glm::distance(session_->view.camera.target, picked->place), 0, 1e-6);
}

TEST_F(GizmoTest, ctrl_snaps_to_the_grid) {
  const glm::dvec3 before = middle();
  run({"view front"});
  drag(HandleWay::x, {57, 200}, " Ctrl");
  const double moved = middle().x - before.x;
  const double steps = moved / step_of_ground(session_->mesh()).size();
  EXPECT_NE(moved, 0);
  EXPECT_NEAR(steps, std::round(steps), 1e-9) << moved;
}

TEST_F(GizmoTest, the_pointer_finds_a_handle_before_an_element_and_elsewhere_the_drag_orbits) {
  run({"move " + text(pixel_of(HandleWay::x))});
  ASSERT_TRUE(session_->pointing.pointed_handle());
  EXPECT_EQ(session_->pointing.pointed_handle()->way, HandleWay::x);
  EXPECT_FALSE(session_->selecting.hover());
  run({"move " + text(pixel_of(HandleWay::x)) + " Shift"});
  EXPECT_FALSE(session_->pointing.pointed_handle()) << "Shift adds to the selection there";
  run({"move " + text(pixel_of(HandleWay::x)), "open \"" + test::asset("cube.obj") + "\""});
  EXPECT_FALSE(session_->pointing.pointed_handle()) << "another mesh has none at first";
  const Camera camera = session_->view.camera;
  run({"press left 20,20", "move 80,60", "release left 80,60"});
  EXPECT_NE(session_->view.camera, camera);
  EXPECT_TRUE(session_->document().history().empty());
}

TEST_F(GizmoTest, is_there_only_with_select_in_hand_and_something_selected) {
  EXPECT_TRUE(session_->pointing.gizmo());
  run({"tool collapse"});
  EXPECT_FALSE(session_->pointing.gizmo());
  run({"tool none", "select none"});
  EXPECT_FALSE(session_->pointing.gizmo());
  run({"select v0", "gizmo off"});
  EXPECT_FALSE(session_->pointing.gizmo());
}

TEST_F(GizmoTest, keeps_its_size_in_pixels_and_leaves_out_what_points_at_the_eye) {
  const auto length_px = [&](HandleWay way) {
    const auto gizmo = session_->pointing.gizmo();
    for (const GizmoHandle& handle : gizmo->handles)
      if (handle.row->way == way)
        return glm::length(project(session_->view.camera, session_->view.size, handle.strokes[0].b)->pixel -
                           project(session_->view.camera, session_->view.size, middle())->pixel);
    return 0.0;
  };
  run({"view front", "projection orthographic"});
  EXPECT_EQ(length_px(HandleWay::z), 0) << "along the view";
  const double before = length_px(HandleWay::x);
  EXPECT_NEAR(before, 84, 1e-6);
  run({"wheel 7 640,360"});
  EXPECT_NEAR(length_px(HandleWay::x), before, 1e-6);
}

TEST_F(GizmoTest, other_handles_turn_and_scale) {
  run({"gizmo turn"});
  drag(HandleWay::y, {60, 40});
  EXPECT_TRUE(session_->log().back().starts_with("rotate angle=")) << session_->log().back();
  EXPECT_NE(session_->log().back().find("axis=0,1,0"), std::string::npos);
  run({"gizmo scale"});
  drag(HandleWay::x, {60, 10});
  EXPECT_TRUE(session_->log().back().starts_with("scale factor=")) << session_->log().back();
  EXPECT_NE(session_->log().back().find("axis=1,0,0"), std::string::npos);
}

TEST_F(GizmoTest, shift_and_an_axis_keep_a_movement_in_the_plane_across) {
  const glm::dvec3 before = middle();
  run({"move 640,360", "key G", "key Shift+Y", "move 720,300"});
  EXPECT_TRUE(session_->gesturing.transform()->is_in_plane());
  run({"key Enter"});
  EXPECT_NEAR(middle().y - before.y, 0, 1e-12);
  EXPECT_GT(glm::distance(middle(), before), 1e-3);
}

TEST_F(GizmoTest, alt_and_a_click_select_the_loop_or_ring_of_the_nearest_edge) {
  run({"gizmo off", "new", "torus", "frame all", "mode face", "select none"});
  int y = 50;
  while (y < 700 && !session_->pointing.pick({640, y}, PickMode::face)) y += 10;
  const std::string where = "640," + std::to_string(y);
  run({"press left " + where + " Alt", "release left " + where + " Alt"});
  const Elements loop = session_->selecting.selection;
  ASSERT_GT(loop.size(), 2u);
  EXPECT_EQ(loop[0].kind, Element::Kind::edge);
  run({"press left " + where + " Ctrl+Alt", "release left " + where + " Ctrl+Alt"});
  const Elements ring = session_->selecting.selection;
  ASSERT_GT(ring.size(), 2u);
  EXPECT_NE(ring, loop);
  run({"press left " + where + " Shift+Alt", "release left " + where + " Shift+Alt"});
  EXPECT_EQ(session_->selecting.selection.size(), ring.size() + loop.size() - 1) << "they share the edge";
}

}  // namespace
}  // namespace ryosen
