#include "ryosen/geometry/closest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

namespace ryosen {
namespace {

using Corners3 = std::vector<glm::dvec3>;

const Corners3 floor_triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

void expect_way(const Corners3& a, const Corners3& b, double length) {
  const ShortestWay way = shortest_way(a, b), back = shortest_way(b, a);
  EXPECT_NEAR(way.length, length, 1e-12);
  EXPECT_NEAR(back.length, length, 1e-12);
  EXPECT_NEAR(glm::distance(way.from, way.to), length, 1e-12);
}

TEST(shortest_way, of_points_segments_and_triangles_is_what_one_computes_by_hand) {
  expect_way({{0, 0, 0}}, {{1, 2, 2}}, 3);
  expect_way({{1, 1, 5}}, floor_triangle, 5);
  expect_way({{-3, 0, 4}}, floor_triangle, 5);
  expect_way({{4, 4, 0}}, floor_triangle, std::sqrt(8.0));
  expect_way({{0, 0, 0}, {1, 0, 0}}, {{0.5, -1, 2}, {0.5, 1, 2}}, 2);
  expect_way({{0, 0, 0}, {1, 0, 0}}, {{3, 0, 0}, {4, 0, 0}}, 2);
  expect_way({{1, 1, -1}, {1, 1, 1}}, floor_triangle, 0);
  expect_way({{5, 5, -1}, {5, 5, 1}}, floor_triangle, std::sqrt(18.0));
  expect_way({{1, 1, 2}, {2, 1, 3}, {1, 2, 3}}, floor_triangle, 2);
  expect_way({{1, 1, -1}, {1, 1, 1}, {9, 9, 9}}, floor_triangle, 0);
  expect_way({{1, 1, 1}, {1, 1, 1}}, floor_triangle, 1);
}

// Points spread evenly over what corners span.
Corners3 spread_over(const Corners3& corners, int steps) {
  Corners3 points;
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; k <= (corners.size() == 3 ? steps - i : 0); ++k) {
      const double s = double(i) / steps, t = double(k) / steps;
      glm::dvec3 p = corners[0];
      if (corners.size() > 1) p += s * (corners[1] - corners[0]);
      if (corners.size() > 2) p += t * (corners[2] - corners[0]);
      points.push_back(p);
    }
  return points;
}

TEST(shortest_way, is_never_longer_than_between_any_points_and_hardly_shorter_than_the_best_of_many) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> somewhere(-1, 1);
  for (int round = 0; round < 150; ++round) {
    const auto corners = [&] {
      Corners3 all(1 + random() % 3);
      for (glm::dvec3& p : all) p = {somewhere(random), somewhere(random), somewhere(random)};
      return all;
    };
    const Corners3 a = corners(), b = corners();
    double best = 1e9;
    for (const glm::dvec3& p : spread_over(a, 24))
      for (const glm::dvec3& q : spread_over(b, 24)) best = std::min(best, glm::distance(p, q));
    const double length = shortest_way(a, b).length;
    EXPECT_LE(length, best + 1e-12) << round;
    EXPECT_GE(length, best - 0.25) << round;
  }
}

}  // namespace
}  // namespace ryosen
