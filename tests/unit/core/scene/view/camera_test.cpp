#include "ryosen/scene/view/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace ryosen {
namespace {

constexpr Size window{640, 360};
constexpr double aspect = 640.0 / 360;

void expect_close(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12) {
  EXPECT_LE(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " | " << b.x << " " << b.y << " " << b.z;
}

Camera slanted(bool ortho) {
  Camera camera;
  camera.eye = {3, 2, 5};
  camera.target = {0.3, -0.2, 0.1};
  return with_ortho(camera, ortho);
}

std::vector<glm::dvec3> cloud(const glm::dvec3& at, double scale) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 200; ++i) {
    points.push_back(at + scale * glm::dvec3(std::sin(i * 1.7), 0.4 * std::cos(i * 2.3), 0.7 * std::sin(i * 0.9 + 1)));
  }
  return points;
}

TEST(camera, ray_through_a_projected_point_meets_it) {
  for (const bool ortho : {false, true}) {
    const Camera camera = slanted(ortho);
    for (const glm::dvec3& p : cloud({0, 0, 0}, 1)) {
      const auto screen = project(camera, window, p);
      ASSERT_TRUE(screen);
      const Ray ray = ray_through(camera, window, screen->pixel);
      EXPECT_NEAR(glm::length(ray.direction), 1, 1e-14);
      const double along = glm::dot(p - ray.origin, ray.direction);
      expect_close(ray.origin + along * ray.direction, p);
    }
  }
}

TEST(camera, projection_agrees_with_the_matrices) {
  for (const bool ortho : {false, true}) {
    const Camera camera = slanted(ortho);
    const glm::dmat4 clip = clip_from_view(camera, aspect, 0.5, 50) * view_from_mesh(camera);
    for (const glm::dvec3& p : cloud({0, 0, 0}, 1)) {
      const glm::dvec4 c = clip * glm::dvec4(p, 1.0);
      const auto screen = project(camera, window, p);
      EXPECT_NEAR(screen->pixel.x, (c.x / c.w + 1) / 2 * window.width, 1e-9);
      EXPECT_NEAR(screen->pixel.y, (1 - c.y / c.w) / 2 * window.height, 1e-9);
    }
  }
}

TEST(camera, depth_planes_map_to_the_ends_of_clip_space) {
  for (const bool ortho : {false, true}) {
    const Camera camera = slanted(ortho);
    for (const double distance : {0.5, 50.0}) {
      const glm::dvec4 c = clip_from_view(camera, aspect, 0.5, 50) * glm::dvec4(0, 0, -distance, 1);
      EXPECT_NEAR(c.z / c.w, distance < 1 ? -1 : 1, 1e-12);
    }
  }
}

TEST(camera, fitted_points_touch_the_margin_and_no_more) {
  for (const bool ortho : {false, true}) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const std::vector<glm::dvec3> points = cloud(scale * glm::dvec3(7, 8, -9), scale);
      const Camera camera = fitted(slanted(ortho), points, aspect, 0.1);
      glm::dvec2 low(1e9), high(-1e9);
      for (const glm::dvec3& p : points) {
        const auto screen = project(camera, window, p);
        ASSERT_TRUE(screen);
        low = glm::min(low, screen->pixel);
        high = glm::max(high, screen->pixel);
      }
      EXPECT_GE(low.x, 64 - 1e-6);
      EXPECT_LE(high.x, 576 + 1e-6);
      EXPECT_GE(low.y, 36 - 1e-6);
      EXPECT_LE(high.y, 324 + 1e-6);
      const bool wide = std::abs(high.x - low.x - 512) < 1e-3, high_enough = std::abs(high.y - low.y - 288) < 1e-3;
      EXPECT_TRUE(wide || high_enough);
    }
  }
}

TEST(camera, fitting_odd_inputs_leaves_a_usable_camera) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool ortho : {false, true}) {
    const std::vector<std::vector<glm::dvec3>> inputs = {
        {}, {{4, 5, 6}}, {{0, 0, 0}, {0, 0, 3}}, {{nan, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {1, 1, 1}}};
    for (const std::vector<glm::dvec3>& points : inputs) {
      Camera front;
      front = fitted(with_ortho(front, ortho), points, aspect);
      EXPECT_GT(glm::length(front.target - front.eye), 0);
      EXPECT_TRUE(std::isfinite(front.eye.x + front.eye.y + front.eye.z));
      if (front.ortho_height) {
        EXPECT_GT(*front.ortho_height, 0);
      }
      for (const glm::dvec3& p : points) {
        if (std::isnan(p.x)) continue;
        const auto screen = project(front, window, p);
        ASSERT_TRUE(screen);
        EXPECT_NEAR(screen->pixel.x, 320, 321);
      }
    }
  }
}

// A point away from the target, nearer to the eye than it.
glm::dvec3 point_beside(const Camera& camera) {
  const CameraAxes a = axes(camera);
  return camera.target - 0.4 * glm::length(camera.target - camera.eye) * a.forward + 0.3 * a.right + 0.2 * a.up;
}

glm::dvec2 pixel_of(const Camera& camera, const glm::dvec3& p) { return project(camera, window, p)->pixel; }

TEST(camera, zoom_keeps_its_point_in_the_view_and_never_goes_through_it) {
  for (const bool ortho : {false, true}) {
    Camera camera = slanted(ortho);
    const glm::dvec3 fixed = point_beside(camera);
    const glm::dvec2 pixel = pixel_of(camera, fixed);
    for (int notch = 0; notch < 60; ++notch) {
      const Camera closer = zoomed(camera, 1.15, fixed);
      EXPECT_NEAR(glm::length(pixel_of(closer, fixed) - pixel), 0, 1e-6);
      EXPECT_NEAR(units_per_pixel(closer, window, depth_of(closer, fixed)) * 1.15,
                  units_per_pixel(camera, window, depth_of(camera, fixed)), 1e-12);
      if (!ortho) {
        EXPECT_NEAR(depth_of(closer, fixed) * 1.15, depth_of(camera, fixed), 1e-12);
      }
      EXPECT_GT(depth_of(closer, fixed), 0);
      camera = closer;
    }
    expect_close(zoomed(zoomed(camera, 3, fixed), 1 / 3.0, fixed).eye, camera.eye, 1e-12);
  }
}

TEST(camera, pan_keeps_what_was_grabbed_under_the_pointer) {
  for (const bool ortho : {false, true}) {
    const Camera camera = slanted(ortho);
    for (const glm::dvec3& grabbed : {camera.target, point_beside(camera)}) {
      const glm::dvec2 to = pixel_of(panned(camera, {30, -12}, window, grabbed), grabbed);
      EXPECT_NEAR(glm::length(to - pixel_of(camera, grabbed) - glm::dvec2(30, -12)), 0, 1e-9);
    }
  }
}

TEST(camera, orbit_keeps_its_point_in_the_view) {
  for (const bool ortho : {false, true}) {
    const Camera camera = slanted(ortho);
    const glm::dvec3 about = point_beside(camera);
    Camera turned = camera;
    for (int i = 0; i < 40; ++i) {
      turned = orbited(turned, {17, -5}, window, about);
      EXPECT_NEAR(glm::length(pixel_of(turned, about) - pixel_of(camera, about)), 0, 1e-6);
      EXPECT_NEAR(glm::length(turned.eye - about), glm::length(camera.eye - about), 1e-9);
      EXPECT_NEAR(glm::length(turned.target - turned.eye), glm::length(camera.target - camera.eye), 1e-9);
    }
  }
}

TEST(camera, orbit_keeps_distance_and_stops_at_the_poles) {
  const Camera camera = slanted(false);
  const double distance = glm::length(camera.target - camera.eye);
  Camera turned = camera;
  for (int i = 0; i < 100; ++i) {
    turned = orbited(turned, {13, 9}, window, camera.target);
    EXPECT_EQ(turned.target, camera.target);
    EXPECT_NEAR(glm::length(turned.target - turned.eye), distance, 1e-9);
    EXPECT_GE(axes(turned).up.y, -1e-9);
  }
  EXPECT_NEAR(axes(turned).forward.y, -1, 1e-6);
  // Back again, sideways only: a full turn is four half views.
  const Camera around = orbited(camera, {4.0 * window.height / 2, 0}, window, camera.target);
  expect_close(around.eye, camera.eye, 1e-9);
  // Dragging to the right brings the left side to the front: the eye goes left.
  EXPECT_LT(glm::dot(orbited(camera, {5, 0}, window, camera.target).eye - camera.eye, axes(camera).right), 0);
}

TEST(camera, a_new_centre_moves_the_eye_parallel_to_the_view) {
  for (const bool ortho : {false, true}) {
    const Camera camera = slanted(ortho);
    const glm::dvec3 point = point_beside(camera);
    const Camera centre = centred(camera, point);
    EXPECT_EQ(centre.target, point);
    EXPECT_NEAR(glm::dot(centre.eye - camera.eye, axes(camera).forward), 0, 1e-12);
    EXPECT_NEAR(glm::length(axes(centre).forward - axes(camera).forward), 0, 1e-12);
    EXPECT_NEAR(glm::length(pixel_of(centre, point) - glm::dvec2(window.width, window.height) / 2.0), 0, 1e-6);
  }
}

TEST(camera, a_pixel_and_a_depth_are_a_place) {
  for (const bool ortho : {false, true}) {
    const Camera camera = slanted(ortho);
    const glm::dvec3 place = place_at(camera, window, {500, 90}, 1.25);
    EXPECT_NEAR(glm::length(pixel_of(camera, place) - glm::dvec2(500, 90)), 0, 1e-9);
    EXPECT_NEAR(depth_of(camera, place), 1.25, 1e-12);
  }
}

TEST(camera, switching_the_projection_keeps_the_target_as_large) {
  const Camera camera = slanted(false);
  const Camera ortho = with_ortho(camera, true);
  EXPECT_NEAR(units_per_pixel(ortho, window, 1),
              units_per_pixel(camera, window, glm::length(camera.target - camera.eye)), 1e-12);
  expect_close(with_ortho(ortho, false).eye, camera.eye, 1e-12);
}

TEST(camera, points_behind_the_eye_are_not_projected) {
  const Camera camera = slanted(false);
  EXPECT_FALSE(project(camera, window, camera.eye + (camera.eye - camera.target)));
  EXPECT_TRUE(project(slanted(true), window, camera.eye + (camera.eye - camera.target)));
}

}  // namespace
}  // namespace ryosen
