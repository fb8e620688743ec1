#include "ryosen/geometry/frustum.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace ryosen {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

bool holds(const Frustum& frustum, const dvec3& p) {
  for (std::size_t i = 0; i < frustum.count; ++i) {
    if (glm::dot(frustum.planes[i], dvec4(p, 1.0)) < 0.0) return false;
  }
  return true;
}

TEST(frustum, holds_exactly_what_projects_near_the_pixel) {
  const dvec2 size(640, 480);
  const glm::dmat4 look = glm::lookAt(dvec3(3, 2, 5), dvec3(0, 0, 0), dvec3(0, 1, 0));
  for (const glm::dmat4& projection :
       {glm::perspective(0.8, size.x / size.y, 0.1, 50.0), glm::ortho(-4.0, 4.0, -3.0, 3.0, 0.1, 50.0)}) {
    const glm::dmat4 clip = projection * look;
    const dvec2 pixel(400, 180);
    const Frustum frustum = frustum_around_pixel(clip, size, pixel, 40.0);
    int inside = 0;
    for (int i = 0; i < 20 * 20 * 20; ++i) {
      const dvec3 p(-4.0 + 0.41 * (i % 20), -4.0 + 0.41 * (i / 20 % 20), -4.0 + 0.41 * (i / 400));
      const dvec4 c = clip * dvec4(p, 1.0);
      const dvec2 seen((c.x / c.w + 1.0) * 0.5 * size.x, (1.0 - c.y / c.w) * 0.5 * size.y);
      const bool expected = c.z >= -c.w && std::abs(seen.x - pixel.x) <= 40.0 && std::abs(seen.y - pixel.y) <= 40.0;
      EXPECT_EQ(holds(frustum, p), expected);
      inside += expected;
    }
    EXPECT_GT(inside, 20);
  }
}

TEST(frustum, nothing_behind_the_eye) {
  const glm::dmat4 clip = glm::perspective(1.0, 1.0, 0.1, 10.0);
  const Frustum frustum = frustum_of_rectangle(clip, dvec2(-1), dvec2(1));
  EXPECT_TRUE(holds(frustum, {0, 0, -5}));
  EXPECT_TRUE(holds(frustum, {0, 0, -500}));
  EXPECT_FALSE(holds(frustum, {0, 0, 5}));
  EXPECT_FALSE(holds(frustum, {0, 0, -0.05}));
}

}  // namespace
}  // namespace ryosen
