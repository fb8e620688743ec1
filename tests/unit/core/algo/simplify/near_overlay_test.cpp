// Bounds from laid-over triangles, judged by dense samples and slow distances.
#include "ryosen/algo/simplify/near_overlay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/core/farthest_sample.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

TriangleCorners corners_at_random(Dice& dice, double height) {
  TriangleCorners corners;
  for (glm::dvec3& corner : corners) {
    const double x = dice.unit(), y = dice.unit();
    corner = {x, y, height * dice.unit()};
  }
  return corners;
}

TEST(near_overlay, says_nothing_that_samples_deny) {
  Dice dice(7);
  NearOverlay overlay;
  for (const double height : {0.0, 0.01, 0.2, 1.0, 5.0}) {
    std::size_t bounded = 0;
    for (int i = 0; i < 400; ++i) {
      std::vector<NearTarget> targets;
      for (int k = dice.below(8) + 1; k > 0; --k)
        targets.push_back(target_of(corners_at_random(dice, height), dice.one_in(2) ? 0 : 0.1 * dice.unit()));
      TriangleCorners triangle = corners_at_random(dice, height);
      if (dice.one_in(10)) triangle[2] = 0.5 * triangle[0] + 0.5 * triangle[1];  // without area
      if (dice.one_in(10)) targets[0] = target_of({triangle[1], triangle[1], triangle[0]}, 0);
      const double most = dice.one_in(3) ? no_limit : 0.4, bound = overlay.bound(triangle, targets, most);
      if (bound > most) continue;
      ++bounded;
      EXPECT_LE(farthest_sample(triangle, targets, 10), bound + 1e-13) << i;
    }
    EXPECT_GT(bounded, 50u) << height;
  }
}

// A fan of triangles under one that covers a part of it; the bound is the distance.
TEST(near_overlay, is_the_distance_from_a_sheet_before_the_triangle) {
  for (const double peak : {0.0, 0.001, 0.05, 0.3, 1.0})
    for (const std::size_t n : {3u, 5u, 8u, 13u, 40u}) {
      std::vector<NearTarget> fan;
      const auto at = [&](std::size_t i) {
        const double turn = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
        return glm::dvec3(3 * std::cos(turn), 3 * std::sin(turn), 0.0);
      };
      for (std::size_t i = 0; i < n; ++i) fan.push_back(target_of({glm::dvec3(0, 0, peak), at(i), at(i + 1)}, 0));
      const TriangleCorners triangle{glm::dvec3(-0.6, -0.4, 0), {0.6, -0.4, 0}, {0, 0.7, 0}};
      NearOverlay overlay;
      const double bound = overlay.bound(triangle, fan, no_limit);
      EXPECT_LE(bound, peak + 1e-12) << n;
      EXPECT_GE(bound, farthest_sample(triangle, fan, 20) - 1e-12) << n;
      EXPECT_LE(bound, 1.2 * farthest_sample(triangle, fan, 20) + 1e-12) << n << " " << peak;
      EXPECT_GT(overlay.bound(triangle, fan, 0.3 * bound), 0.3 * bound);
    }
}

}  // namespace
}  // namespace ryosen::test
