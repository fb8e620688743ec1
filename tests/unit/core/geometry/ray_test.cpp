#include "ryosen/geometry/ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

namespace ryosen {
namespace {

using glm::dvec3;

TEST(ray, hits_both_sides_and_reports_place_and_weights) {
  const dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  for (const double side : {1.0, -1.0}) {
    const RayCaster caster(Ray{{0.25, 0.5, 3.0 * side}, {0, 0, -2.0 * side}});
    const auto hit = caster.hit(a, b, c);
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->t, 1.5);
    EXPECT_NEAR(glm::distance(hit->barycentric, dvec3(0.25, 0.25, 0.5)), 0.0, 1e-15);
  }
}

TEST(ray, misses_beside_behind_and_beyond_the_limits) {
  const dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_FALSE(RayCaster(Ray{{0.6, 0.6, 1}, {0, 0, -1}}).hit(a, b, c));
  EXPECT_FALSE(RayCaster(Ray{{0.2, 0.2, 1}, {0, 0, 1}}).hit(a, b, c));
  EXPECT_FALSE(RayCaster(Ray{{0.2, 0.2, 1}, {0, 0, -1}, 0.0, 0.5}).hit(a, b, c));
  EXPECT_FALSE(RayCaster(Ray{{0.2, 0.2, 1}, {0, 0, -1}, 1.5, 9.0}).hit(a, b, c));
  EXPECT_TRUE(RayCaster(Ray{{0.2, 0.2, 1}, {0, 0, -1}, 1.0, 1.0}).hit(a, b, c));
  EXPECT_FALSE(RayCaster(Ray{{0.2, 0.2, 0}, {1, 0, 0}}).hit(a, b, c));              // edge-on
  EXPECT_FALSE(RayCaster(Ray{{0.2, 0, 1}, {0, 0, -1}}).hit(a, b, dvec3(2, 0, 0)));  // flat
  EXPECT_FALSE(RayCaster(Ray{{0, 0, 0}, {0, 0, 0}}).is_valid());
}

TEST(ray, the_order_of_the_corners_changes_nothing) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  int hits = 0;
  for (int round = 0; round < 20000; ++round) {
    const dvec3 origin = vector() * 3.0;
    const RayCaster caster(Ray{origin, vector() * 0.3 - origin});
    const std::array<dvec3, 3> p = {vector(), vector(), vector()};
    const auto first = caster.hit(p[0], p[1], p[2]);
    hits += first.has_value();
    std::array<std::size_t, 3> order = {0, 1, 2};
    do {
      const auto again = caster.hit(p[order[0]], p[order[1]], p[order[2]]);
      ASSERT_EQ(first.has_value(), again.has_value());
      if (!first) continue;
      EXPECT_EQ(first->t, again->t);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(first->barycentric[static_cast<int>(order[i])], again->barycentric[static_cast<int>(i)]);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  EXPECT_GT(hits, 1000);
}

TEST(ray, none_slips_between_triangles_that_share_edges) {
  // A fan around a point off all grids; rays through its edges and its tip must hit one of the triangles.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const dvec3 tip(0.1, 0.7, 1.0 / 3.0);
  std::vector<dvec3> rim;
  for (int i = 0; i < 7; ++i) rim.emplace_back(3 * std::cos(0.9 * i), 3 * std::sin(0.9 * i), 0.2 * unit(random));
  for (int round = 0; round < 20000; ++round) {
    const std::size_t i = random() % rim.size();
    const dvec3 target = round % 10 == 0 ? tip : glm::mix(tip, rim[i], 0.5 + 0.45 * unit(random));
    const dvec3 origin(unit(random), unit(random), 5.0 + unit(random));
    const RayCaster caster(Ray{origin, target - origin});
    bool any = false;
    for (std::size_t k = 0; k < rim.size(); ++k) any = any || caster.hit(tip, rim[k], rim[(k + 1) % rim.size()]);
    EXPECT_TRUE(any);
  }
}

}  // namespace
}  // namespace ryosen
