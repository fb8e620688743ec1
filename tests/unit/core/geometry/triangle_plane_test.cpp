#include "ryosen/geometry/triangles_meet.h"

#include <gtest/gtest.h>

#include "ryosen/geometry/predicates.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

using Corners = std::array<glm::dvec3, 3>;

bool is_on_one_side(const Corners& a, const Corners& b) {
  const int side = orient3d(a[0], a[1], a[2], b[0]);
  return side != 0 && orient3d(a[0], a[1], a[2], b[1]) == side && orient3d(a[0], a[1], a[2], b[2]) == side;
}

// On a grid many corners lie in the plane or next to it, seen from far away and in units of all sizes.
TEST(triangle_plane, is_clear_only_of_what_lies_on_one_side) {
  Dice dice(3);
  std::size_t clear = 0, on_one_side = 0;
  for (int round = 0; round < 100000; ++round) {
    const double unit = dice.one_in(4) ? 1e-160 : dice.one_in(4) ? 1e140 : 0.1, shift = dice.one_in(2) ? 1e7 : 0.0;
    const auto corner = [&] {
      const auto number = [&] { return unit * (shift + dice.below(5)); };
      return glm::dvec3(number(), number(), number());
    };
    const Corners a{corner(), corner(), corner()}, b{corner(), corner(), corner()};
    const bool is_clear = TrianglePlane(a).is_clear_of(b), is_aside = is_on_one_side(a, b);
    EXPECT_TRUE(!is_clear || is_aside) << round;
    clear += is_clear;
    on_one_side += is_aside;
  }
  EXPECT_GT(clear, on_one_side / 4);
}

TEST(triangle_plane, nothing_is_clear_of_a_triangle_without_area) {
  const Corners line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
  EXPECT_FALSE(TrianglePlane(line).is_clear_of({{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}}));
  EXPECT_FALSE(TrianglePlane().is_clear_of({{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}}));
}

}  // namespace
}  // namespace ryosen::test
