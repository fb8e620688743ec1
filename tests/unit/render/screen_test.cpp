#include "render/screen.h"

#include <gtest/gtest.h>

#include <array>

#include "ryosen/scene/view/camera.h"

namespace ryosen {
namespace {

constexpr Size screen_view{400, 300};

glm::mat4 clip_of(const Camera& camera) {
  return glm::mat4(clip_from_view(camera, 4.0 / 3, 0.1, 100) * view_from_mesh(camera));
}

TEST(screen, bounds_hold_the_pixels_that_the_camera_projects_to) {
  Camera camera;
  camera.eye = {1, 2, 6};
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 p(0.03 * i - 0.7, 0.02 * (i % 13), 0.05 * (i % 7));
    const glm::dvec2 pixel = project(camera, screen_view, p)->pixel;
    const std::array<glm::vec3, 1> points{glm::vec3(p)};
    const PixelRect rect = screen_bounds(points, clip_of(camera), screen_view, 0);
    EXPECT_LE(rect.x0, pixel.x);
    EXPECT_GE(rect.x1, pixel.x);
    EXPECT_LE(rect.y0, pixel.y);
    EXPECT_GE(rect.y1, pixel.y);
    EXPECT_LE(rect.width(), 4);
    EXPECT_LE(rect.height(), 4);
  }
}

TEST(screen, points_behind_the_eye_touch_everything) {
  Camera camera;
  camera.eye = {0, 0, 5};
  const std::array<glm::vec3, 2> points{glm::vec3(0, 0, 0), glm::vec3(0, 0, 9)};
  EXPECT_EQ(screen_bounds(points, clip_of(camera), screen_view, 0), PixelRect::all(screen_view));
}

TEST(screen, what_lies_beside_the_view_touches_nothing) {
  Camera camera;
  camera.eye = {0, 0, 5};
  DrawBox box;
  EXPECT_TRUE(screen_bounds(box, clip_of(camera), screen_view, 5).empty());
  box.add(glm::vec3(50, 0, 0));
  EXPECT_TRUE(screen_bounds(box, clip_of(camera), screen_view, 5).empty());
  box.add(glm::vec3(0, 0, 0));
  const PixelRect rect = screen_bounds(box, clip_of(camera), screen_view, 5);
  EXPECT_EQ(rect.x1, 400);
  EXPECT_NEAR(rect.x0, 194, 1);
}

}  // namespace
}  // namespace ryosen
