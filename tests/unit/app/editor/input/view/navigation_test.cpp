#include "app/editor/input/view/navigation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/geometry/box.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

constexpr glm::dvec2 middle{640, 360};

std::unique_ptr<Session> torus() {
  auto document = Document::open(test::asset("torus.off"));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

double distance_to_target(const Session& session) {
  return glm::length(session.view.camera.eye - session.view.camera.target);
}

// A press, a move by (40, 20), a release. Returns the camera before.
Camera drag(Session& session, MouseButton button, Modifiers modifiers = {}) {
  Navigation navigation;
  const Camera before = session.view.camera;
  navigation.press(button, middle, modifiers, drag_action_of(input_presets()[0], button, modifiers));
  EXPECT_TRUE(navigation.move(session, middle + glm::dvec2(40, 20)));
  EXPECT_FALSE(navigation.release(button, middle + glm::dvec2(40, 20), 1));
  return before;
}

void expect_orbited(const Session& session, const Camera& before) {
  EXPECT_EQ(session.view.camera.target, before.target);
  EXPECT_NE(session.view.camera.eye, before.eye);
}

void expect_panned(const Session& session, const Camera& before) {
  EXPECT_NE(session.view.camera.target, before.target);
  const glm::dvec3 turned = (session.view.camera.eye - session.view.camera.target) - (before.eye - before.target);
  EXPECT_LT(glm::length(turned), 1e-12);
}

TEST(navigation, drags_do_what_the_status_line_says) {
  const auto session = torus();
  expect_orbited(*session, drag(*session, MouseButton::left));
  expect_panned(*session, drag(*session, MouseButton::right));
  expect_panned(*session, drag(*session, MouseButton::left, {.shift = true}));
  expect_orbited(*session, drag(*session, MouseButton::middle));
  expect_panned(*session, drag(*session, MouseButton::middle, {.shift = true}));
  const double before = distance_to_target(*session);
  drag(*session, MouseButton::middle, {.ctrl = true});
  EXPECT_GT(distance_to_target(*session), before);
}

constexpr glm::dvec2 on_torus{640, 560};

TEST(navigation, the_wheel_goes_towards_the_surface_and_never_through_it) {
  const auto session = torus();
  const auto picked = session->pointing.pick(on_torus, PickMode::face);
  ASSERT_TRUE(picked);
  double depth = depth_of(session->view.camera, picked->place);
  for (int notch = 0; notch < 100; ++notch) {
    Navigation().wheel(*session, on_torus, 1);
    const double now = depth_of(session->view.camera, picked->place);
    EXPECT_NEAR(now * 1.15, depth, 1e-9);
    EXPECT_LT(glm::length(project(session->view.camera, session->view.size, picked->place)->pixel - on_torus), 0.5)
        << notch;
    depth = now;
  }
  EXPECT_GT(depth, 0);
}

TEST(navigation, the_wheel_over_the_background_goes_as_far_as_the_nearest_surface_allows) {
  const auto session = torus();
  session->view.origin = {100, 50};
  const glm::dvec2 pixel = glm::dvec2(3, 3) + session->view.origin;
  ASSERT_FALSE(session->pointing.pick(pixel, PickMode::face));
  const Ray ray = ray_through(session->view.camera, session->view.size, pixel - session->view.origin);
  const glm::dvec3 forward = axes(session->view.camera).forward;
  const glm::dvec3 before = session->view.camera.eye;
  double nearest = 1e300;
  for (const glm::dvec3& p : session->mesh().positions())
    nearest = std::min(nearest, depth_of(session->view.camera, p));
  Navigation().wheel(*session, pixel, 1);
  const double gone = glm::dot(session->view.camera.eye - before, forward);
  EXPECT_GT(gone, 0);
  EXPECT_NEAR(gone, nearest * (1 - 1 / 1.15), 0.1 * gone);
  const Ray after = ray_through(session->view.camera, session->view.size, pixel - session->view.origin);
  EXPECT_LT(glm::length(ray.direction - after.direction), 1e-12);
}

TEST(navigation, drags_hold_on_to_the_point_that_was_pressed) {
  for (const MouseButton button : {MouseButton::left, MouseButton::right}) {
    const auto session = torus();
    const glm::dvec3 held = session->pointing.pick(on_torus, PickMode::face)->place;
    const glm::dvec3 target = session->view.camera.target;
    Navigation navigation;
    navigation.press(button, on_torus, {}, drag_action_of(input_presets()[0], button, {}));
    for (int i = 1; i <= 8; ++i) navigation.move(*session, on_torus + glm::dvec2(20, -9) * double(i));
    const glm::dvec2 now = project(session->view.camera, session->view.size, held)->pixel;
    const bool is_pan = button == MouseButton::right;
    EXPECT_LT(glm::length(now - on_torus - (is_pan ? glm::dvec2(160, -72) : glm::dvec2(0))), 0.5);
    EXPECT_NE(session->view.camera.target, target);
  }
}

// The wheel goes by what lies under the pointer, which may leave the target far before all there is.
TEST(navigation, a_drag_beside_the_mesh_turns_about_what_is_seen_wherever_the_target_is) {
  const glm::dvec2 beside(3, 3);
  const auto session = torus();
  Camera& camera = session->view.camera;
  camera.target = camera.eye + 0.01 * (camera.target - camera.eye);
  const glm::dvec3 centre = box_of(session->mesh().positions()).middle(), eye = camera.eye;
  const glm::dvec2 before = project(camera, session->view.size, centre)->pixel;
  ASSERT_FALSE(session->pointing.pick(beside, PickMode::face));
  Navigation navigation;
  navigation.press(MouseButton::left, beside, {}, drag_action_of(input_presets()[0], MouseButton::left, {}));
  for (int i = 1; i <= 8; ++i) navigation.move(*session, beside + glm::dvec2(20, 0) * double(i));
  EXPECT_GT(glm::length(camera.eye - eye), 0.1 * glm::length(centre - eye)) << "it has turned";
  EXPECT_LT(glm::length(project(camera, session->view.size, centre)->pixel - before), 0.5);
}

TEST(navigation, a_switch_turns_about_the_centre) {
  const auto session = torus();
  ASSERT_TRUE(session->run("orbit centre").done());
  const glm::dvec3 target = session->view.camera.target;
  ASSERT_TRUE(session->run("drag 640,560 700,500").done());
  EXPECT_EQ(session->view.camera.target, target);
  ASSERT_TRUE(session->run("orbit point").done());
  ASSERT_TRUE(session->run("drag 640,560 700,500").done());
  EXPECT_NE(session->view.camera.target, target);
}

TEST(navigation, a_click_stays_within_four_pixels) {
  const auto session = torus();
  const Camera before = session->view.camera;
  Navigation navigation;
  navigation.press(MouseButton::left, middle, {}, drag_action_of(input_presets()[0], MouseButton::left, {}));
  EXPECT_FALSE(navigation.move(*session, middle + glm::dvec2(3, 2)));
  const auto click = navigation.release(MouseButton::left, middle + glm::dvec2(3, 2), 1);
  ASSERT_TRUE(click);
  EXPECT_EQ(click->pixel, middle);
  EXPECT_EQ(session->view.camera.eye, before.eye);

  navigation.press(MouseButton::left, middle, {}, drag_action_of(input_presets()[0], MouseButton::left, {}));
  navigation.move(*session, middle + glm::dvec2(30, 0));
  navigation.move(*session, middle);
  EXPECT_FALSE(navigation.release(MouseButton::left, middle, 2)) << "it went away and came back";
}

TEST(navigation, two_quick_clicks_are_a_double_click) {
  const auto session = torus();
  Navigation navigation;
  const auto click_at = [&](double now_s) {
    navigation.press(MouseButton::left, middle, {}, drag_action_of(input_presets()[0], MouseButton::left, {}));
    return navigation.release(MouseButton::left, middle, now_s).value().is_double;
  };
  EXPECT_FALSE(click_at(1.0));
  EXPECT_TRUE(click_at(1.2));
  EXPECT_FALSE(click_at(1.3)) << "the third begins anew";
  EXPECT_FALSE(click_at(9.0));
}

TEST(navigation, the_centre_is_what_was_clicked) {
  const auto session = torus();
  ASSERT_FALSE(set_centre(*session, middle)) << "the hole of the torus";
  const auto picked = session->pointing.pick(on_torus, PickMode::face);
  ASSERT_TRUE(picked);
  ASSERT_TRUE(set_centre(*session, on_torus));
  EXPECT_LT(glm::length(session->view.camera.target - picked->place), 1e-12);
  EXPECT_LT(glm::length(project(session->view.camera, session->view.size, picked->place)->pixel - middle), 1e-6);
}

}  // namespace
}  // namespace ryosen
