#include "ryosen/hull/hull_extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "ryosen/geometry/predicates.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using Points = std::vector<glm::dvec3>;

// In so many dimensions by trying every direction that is normal to two differences of points: the least width is among
// them.
double width_by_trying_all(const Points& points) {
  Points differences;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) differences.push_back(points[i] - points[j]);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < differences.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec3 normal = glm::cross(differences[i], differences[j]);
      const double length = glm::length(normal);
      if (length < 1e-9) continue;
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const glm::dvec3& p : points) {
        low = std::min(low, glm::dot(p, normal) / length);
        high = std::max(high, glm::dot(p, normal) / length);
      }
      least = std::min(least, high - low);
    }
  return least;
}

// Of points in the plane of z: across every side.
double flat_width_by_trying_all(const Points& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& a : points)
    for (const glm::dvec3& b : points) {
      if (a == b) continue;
      const glm::dvec3 normal = glm::normalize(glm::dvec3(a.y - b.y, b.x - a.x, 0));
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const glm::dvec3& p : points) {
        low = std::min(low, glm::dot(p, normal));
        high = std::max(high, glm::dot(p, normal));
      }
      least = std::min(least, high - low);
    }
  return least;
}

std::vector<std::uint32_t> farthest_by_trying_all(const Points& points) {
  std::vector<std::uint32_t> pair{0, 0};
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::uint32_t j = i + 1; j < points.size(); ++j)
      if (compare_lengths({points[i], points[j]}, {points[pair[0]], points[pair[1]]}) > 0) pair = {i, j};
  return pair;
}

// That the planes through what is told hold the hull between them.
void expect_between(const Points& points, const HullExtent& extent, int dimension) {
  const auto& one = extent.between[0];
  const auto& other = extent.between[1];
  glm::dvec3 normal(0.0);
  if (dimension == 2) {
    ASSERT_EQ(one.size(), 2u);
    ASSERT_EQ(other.size(), 1u);
    normal = {points[one[0]].y - points[one[1]].y, points[one[1]].x - points[one[0]].x, 0};
  } else if (other.size() == 1) {
    ASSERT_GE(one.size(), 3u);
    normal = glm::cross(points[one[1]] - points[one[0]], points[one[2]] - points[one[0]]);
  } else {
    ASSERT_EQ(one.size(), 2u);
    ASSERT_EQ(other.size(), 2u);
    normal = glm::cross(points[one[1]] - points[one[0]], points[other[1]] - points[other[0]]);
  }
  normal = glm::normalize(normal);
  const double from = glm::dot(normal, points[one[0]]), to = glm::dot(normal, points[other[0]]);
  const double slack = 1e-9 * (1 + std::abs(from) + std::abs(to));
  EXPECT_NEAR(std::abs(from - to), extent.width, slack);
  for (const glm::dvec3& p : points) {
    EXPECT_GE(glm::dot(normal, p), std::min(from, to) - slack);
    EXPECT_LE(glm::dot(normal, p), std::max(from, to) + slack);
  }
}

Points points_of(int kind, std::size_t count, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> small(-2, 2), spread(-30, 30);
  Points points;
  while (points.size() < count) {
    glm::dvec3 p(normal(random), normal(random), normal(random));
    if (kind == 0) p = {spread(random), spread(random), spread(random)};
    if (kind == 1) p = {small(random), small(random), small(random)};
    if (kind == 2) p /= glm::length(p);
    if (kind == 3) p = {normal(random), 9 * normal(random), 0.1 * normal(random)};
    if (kind == 4) p = {small(random), small(random), points.size() % 2};
    if (kind == 5)
      p = {small(random) * 2 + 0.1 * static_cast<double>(points.size() % 3), small(random), small(random) + 100};
    if (kind >= 6) p = {kind == 6 ? small(random) : spread(random), kind == 6 ? small(random) : spread(random), 0};
    points.push_back(p);
  }
  return points;
}

TEST(hull_extent, is_that_of_trying_all) {
  std::mt19937 random(1);
  const int rounds = test::is_long_run() ? 4000 : 40;
  for (int round = 0; round < rounds; ++round)
    for (int kind = 0; kind < 8; ++kind) {
      SCOPED_TRACE(std::to_string(kind) + " " + std::to_string(round));
      const Points points = points_of(kind, 4 + static_cast<std::size_t>(round) % 9, random);
      const ConvexHull hull = convex_hull(points);
      const HullExtent extent = hull_extent(points, hull);
      if (hull.dimension < 2) continue;
      const std::vector<std::uint32_t> far = farthest_by_trying_all(points);
      ASSERT_EQ(extent.farthest, far);
      EXPECT_NEAR(extent.diameter, glm::length(points[far[0]] - points[far[1]]), 1e-12 * extent.diameter);
      // Points in a plane that is not that of z are measured in theirs; here they have a width of nothing in space.
      if (hull.dimension == 2 && kind < 6) continue;
      const double expected = hull.dimension == 3 ? width_by_trying_all(points) : flat_width_by_trying_all(points);
      ASSERT_NEAR(extent.width, expected, 1e-9 * (1 + expected));
      expect_between(points, extent, hull.dimension);
    }
}

TEST(hull_extent, of_many_points_on_a_sphere_and_of_a_thin_body) {
  std::mt19937 random(3);
  for (const int kind : {2, 3}) {
    const Points points = points_of(kind, 1500, random);
    const ConvexHull hull = convex_hull(points);
    const HullExtent extent = hull_extent(points, hull);
    EXPECT_EQ(extent.farthest, farthest_by_trying_all(points)) << kind;
    // No direction of many is thinner.
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 normal = glm::normalize(points_of(2, 1, random)[0] * glm::dvec3(1, 1, kind == 3 ? 30 : 1));
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const std::uint32_t p : hull.vertices) {
        low = std::min(low, glm::dot(points[p], normal));
        high = std::max(high, glm::dot(points[p], normal));
      }
      ASSERT_LE(extent.width, high - low + 1e-12);
    }
    expect_between(points, extent, 3);
  }
}

TEST(hull_extent, of_a_cube_and_of_a_regular_tetrahedron) {
  Points cube;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  const HullExtent of_cube = hull_extent(cube, convex_hull(cube));
  EXPECT_EQ(of_cube.farthest, (std::vector{0u, 7u})) << "the first of four diagonals";
  EXPECT_DOUBLE_EQ(of_cube.diameter, std::sqrt(3));
  EXPECT_DOUBLE_EQ(of_cube.width, 1);
  const Points regular{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const HullExtent extent = hull_extent(regular, convex_hull(regular));
  EXPECT_DOUBLE_EQ(extent.width, 2) << "between two edges; from a corner to a face it is 2.3";
  EXPECT_EQ(extent.between[0].size(), 2u);
  EXPECT_EQ(extent.between[1].size(), 2u);
  EXPECT_EQ(extent_sentence(extent).en.substr(0, 36), "Farthest apart: v0 and v1, 2.8284271");
}

TEST(hull_extent, below_two_dimensions_and_at_the_ends_of_doubles) {
  EXPECT_EQ(hull_extent({}, convex_hull({})), HullExtent());
  const Points one{{1, 2, 3}, {1, 2, 3}};
  EXPECT_EQ(hull_extent(one, convex_hull(one)), HullExtent());
  const Points line{{0, 0, 0}, {1, 1, 0}, {3, 3, 0}};
  const HullExtent segment = hull_extent(line, convex_hull(line));
  EXPECT_EQ(segment.farthest, (std::vector{0u, 2u}));
  EXPECT_EQ(segment.width, 0);
  EXPECT_TRUE(segment.between[0].empty());
  for (const double scale : {5e-324, 1e-200, 1e200, 2e307}) {
    Points points;
    for (const glm::dvec3& p : Points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 3}, {4, 4, 0}})
      points.push_back(p * scale);
    const HullExtent extent = hull_extent(points, convex_hull(points));
    EXPECT_EQ(extent.farthest, (std::vector{3u, 4u})) << scale;
    EXPECT_NEAR(extent.diameter / scale, scale < 1e-300 ? 6 : std::sqrt(41), 1e-9);
    EXPECT_NEAR(extent.width / scale, scale < 1e-300 ? 2 : 2.4, 1e-9);
  }
}

TEST(hull_extent, is_cancelled) {
  std::mt19937 random(3);
  const Points points = points_of(2, 500, random);
  Progress progress([](double) { return false; });
  EXPECT_EQ(hull_extent(points, convex_hull(points), progress), HullExtent());
}

}  // namespace
}  // namespace ryosen
