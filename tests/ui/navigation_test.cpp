#include "app/ui/navigation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/app/program.h"

namespace ryosen {
namespace {

constexpr glm::dvec2 middle{640, 360};

std::unique_ptr<Session> torus() {
  auto document = Document::open(test::asset("torus.off"));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

double distance_to_target(const Session& session) { return glm::length(session.camera.eye - session.camera.target); }

// A press, a move by (40, 20), a release. Returns the camera before.
Camera drag(Session& session, MouseButton button, Navigation::Modifiers modifiers = {}) {
  Navigation navigation;
  const Camera before = session.camera;
  navigation.press(button, middle, modifiers);
  EXPECT_TRUE(navigation.move(session, middle + glm::dvec2(40, 20)));
  EXPECT_FALSE(navigation.release(button, middle + glm::dvec2(40, 20), 1));
  return before;
}

void expect_orbited(const Session& session, const Camera& before) {
  EXPECT_EQ(session.camera.target, before.target);
  EXPECT_NE(session.camera.eye, before.eye);
}

void expect_panned(const Session& session, const Camera& before) {
  EXPECT_NE(session.camera.target, before.target);
  const glm::dvec3 turned = (session.camera.eye - session.camera.target) - (before.eye - before.target);
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

TEST(navigation, the_wheel_keeps_what_is_under_the_pointer) {
  const auto session = torus();
  session->view_origin = {100, 50};
  const glm::dvec2 pixel = glm::dvec2(400, 300) + session->view_origin;
  const Ray ray = ray_through(session->camera, session->view, pixel - session->view_origin);
  const double before = distance_to_target(*session);
  Navigation().wheel(*session, pixel, 2);
  EXPECT_LT(distance_to_target(*session), before);
  const Ray after = ray_through(session->camera, session->view, pixel - session->view_origin);
  EXPECT_LT(glm::length(ray.direction - after.direction), 1e-12);
}

TEST(navigation, a_click_stays_within_four_pixels) {
  const auto session = torus();
  const Camera before = session->camera;
  Navigation navigation;
  navigation.press(MouseButton::left, middle, {});
  EXPECT_FALSE(navigation.move(*session, middle + glm::dvec2(3, 2)));
  const auto click = navigation.release(MouseButton::left, middle + glm::dvec2(3, 2), 1);
  ASSERT_TRUE(click);
  EXPECT_EQ(click->pixel, middle);
  EXPECT_EQ(session->camera.eye, before.eye);

  navigation.press(MouseButton::left, middle, {});
  navigation.move(*session, middle + glm::dvec2(30, 0));
  navigation.move(*session, middle);
  EXPECT_FALSE(navigation.release(MouseButton::left, middle, 2)) << "it went away and came back";
}

TEST(navigation, two_quick_clicks_are_a_double_click) {
  const auto session = torus();
  Navigation navigation;
  const auto click_at = [&](double now_s) {
    navigation.press(MouseButton::left, middle, {});
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
  const glm::dvec2 pixel(640, 560);
  const auto picked = session->pick(pixel, PickMode::face);
  ASSERT_TRUE(picked);
  ASSERT_TRUE(set_centre(*session, pixel));
  EXPECT_LT(glm::length(session->camera.target - picked->place), 1e-12);
  EXPECT_LT(glm::length(project(session->camera, session->view, picked->place)->pixel - middle), 1e-6);
}

}  // namespace
}  // namespace ryosen
