#include "ryosen/scene/view/packed_normal.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "tests/support/core/random_meshes.h"

namespace ryosen {
namespace {

TEST(packed_normal, comes_back_within_a_hundredth_of_a_degree) {
  Dice dice(3);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 v(2 * dice.unit() - 1, 2 * dice.unit() - 1, 2 * dice.unit() - 1);
    const glm::dvec3 back = unpacked_normal(packed_normal(1e-3 * v));
    EXPECT_LT(glm::length(glm::cross(back, glm::normalize(v))), 1.7e-4) << v.x << " " << v.y << " " << v.z;
    EXPECT_GT(glm::dot(back, v), 0);
  }
}

TEST(packed_normal, keeps_axes_exactly_and_knows_no_direction) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      glm::dvec3 v(0);
      v[axis] = sign;
      EXPECT_EQ(unpacked_normal(packed_normal(v)), v);
    }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(packed_normal(glm::dvec3(0)), no_normal);
  EXPECT_EQ(packed_normal({nan, 1, 0}), no_normal);
  EXPECT_EQ(unpacked_normal(no_normal), glm::dvec3(0));
}

}  // namespace
}  // namespace ryosen
