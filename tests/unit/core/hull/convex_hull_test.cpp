#include "ryosen/hull/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/predicates.h"
#include "tests/support/core/brute_hull.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using namespace test;

BruteHull sets_of(const ConvexHull& hull) {
  BruteHull sets{hull.dimension, hull.vertices, {}};
  for (std::size_t f = 0; f < hull.facet_count(); ++f)
    sets.facets.insert(std::vector(hull.facet(f).begin(), hull.facet(f).end()));
  return sets;
}

std::vector<glm::dvec3> places_of(const std::vector<GridPoint>& points, int exponent) {
  std::vector<glm::dvec3> places;
  for (const GridPoint& p : points)
    places.emplace_back(std::ldexp(static_cast<double>(p[0]), exponent),
                        std::ldexp(static_cast<double>(p[1]), exponent),
                        std::ldexp(static_cast<double>(p[2]), exponent));
  return places;
}

::testing::AssertionResult equals_brute_force(const std::vector<GridPoint>& points, int exponent = 0) {
  const ConvexHull hull = convex_hull(places_of(points, exponent));
  const BruteHull expected = brute_hull(points);
  if (sets_of(hull) == expected && hull.facet_count() == expected.facets.size() && hull.used == points.size())
    return ::testing::AssertionSuccess();
  auto failure = ::testing::AssertionFailure();
  failure << "2^" << exponent << " x ";
  for (const GridPoint& p : points) failure << "(" << p[0] << "," << p[1] << "," << p[2] << ") ";
  failure << "dimension " << hull.dimension << " and " << expected.dimension << ", facets " << hull.facet_count()
          << " and " << expected.facets.size();
  return failure;
}

TEST(convex_hull, answers_below_dimension_three) {
  EXPECT_EQ(convex_hull({}), ConvexHull());
  const glm::dvec3 p(1, 2, 3), q(3, 2, 1);
  const ConvexHull one = convex_hull(std::vector{p, p, p});
  EXPECT_EQ(one.dimension, 0);
  EXPECT_EQ(one.used, 3u);
  EXPECT_EQ(one.vertices, std::vector{0u});
  const ConvexHull two = convex_hull(std::vector{p, (p + q) / 2.0, q, p});
  EXPECT_EQ(two.dimension, 1);
  EXPECT_EQ(two.vertices, (std::vector{0u, 2u}));
  EXPECT_EQ(two.facet_count(), 0u);
  const ConvexHull square =
      convex_hull(std::vector<glm::dvec3>{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}});
  EXPECT_EQ(square.dimension, 2);
  EXPECT_EQ(square.corners, (std::vector{0u, 3u, 2u, 1u}));
  EXPECT_EQ(square.facet_count(), 1u);
}

TEST(convex_hull, leaves_out_what_is_not_finite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const ConvexHull hull =
      convex_hull(std::vector<glm::dvec3>{{nan, 0, 0}, {0, 0, 0}, {inf, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(hull.used, 4u);
  EXPECT_EQ(hull.vertices, (std::vector{1u, 3u, 4u, 5u}));
  EXPECT_EQ(hull.corners, (std::vector{1u, 3u, 5u, 1u, 4u, 3u, 1u, 5u, 4u, 3u, 4u, 5u}));
}

TEST(convex_hull, names_of_equal_points_the_lowest) {
  const ConvexHull hull = convex_hull(std::vector<glm::dvec3>{
      {1, 0, 0}, {0.25, 0.25, 0.25}, {0, 0, 0}, {1, -0.0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, 0, 1}, {0, 1, 0}});
  EXPECT_EQ(hull.vertices, (std::vector{0u, 2u, 4u, 6u}));
}

TEST(convex_hull, a_plane_faces_the_side_of_its_largest_component) {
  // The normal is (1, -1, 0) or its opposite: of equal components the first decides.
  const ConvexHull hull = convex_hull(std::vector<glm::dvec3>{{0, 0, 0}, {1, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(hull.corners, (std::vector{0u, 1u, 2u}));  // (1,1,0) x (0,0,1) = (1,-1,0)
}

// All sets of up to so many points of a grid.
void try_subsets(const std::vector<GridPoint>& grid, std::size_t most, std::vector<GridPoint>& chosen,
                 std::size_t from) {
  ASSERT_TRUE(equals_brute_force(chosen));
  if (chosen.size() == most) return;
  for (std::size_t i = from; i < grid.size(); ++i) {
    chosen.push_back(grid[i]);
    try_subsets(grid, most, chosen, i + 1);
    chosen.pop_back();
    if (::testing::Test::HasFatalFailure()) return;
  }
}

std::vector<GridPoint> grid_of(std::int64_t x, std::int64_t y, std::int64_t z) {
  std::vector<GridPoint> grid;
  for (std::int64_t i = 0; i < x; ++i)
    for (std::int64_t j = 0; j < y; ++j)
      for (std::int64_t k = 0; k < z; ++k) grid.push_back({i, j, k});
  return grid;
}

TEST(convex_hull, equals_brute_force_on_all_sets_of_a_grid) {
  std::vector<GridPoint> chosen;
  try_subsets(grid_of(2, 2, 3), 12, chosen, 0);  // all 4096
  try_subsets(grid_of(4, 4, 1), 5, chosen, 0);
  try_subsets(grid_of(3, 3, 3), is_long_run() ? 6 : 4, chosen, 0);
}

enum class Family { general, coplanar, collinear, cospherical, repeated, lattice, layered };

std::vector<GridPoint> random_points(Family family, std::mt19937& random) {
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  const auto count = static_cast<std::size_t>(number(1, 20));
  const std::int64_t size = number(1, 1 << number(1, 20));
  const auto point = [&](std::int64_t s) { return GridPoint{number(-s, s), number(-s, s), number(-s, s)}; };
  const GridPoint u = point(9), v = point(9), at = point(9);
  static const std::vector<GridPoint> sphere = [] {  // x^2 + y^2 + z^2 = 81
    std::vector<GridPoint> all;
    for (std::int64_t x = -9; x <= 9; ++x)
      for (std::int64_t y = -9; y <= 9; ++y)
        for (std::int64_t z = -9; z <= 9; ++z)
          if (x * x + y * y + z * z == 81) all.push_back({x, y, z});
    return all;
  }();
  std::vector<GridPoint> points;
  while (points.size() < count) {
    switch (family) {
      case Family::general:
        points.push_back(point(size));
        break;
      case Family::coplanar: {
        const std::int64_t s = number(-30, 30), t = number(-30, 30);
        points.push_back({at[0] + s * u[0] + t * v[0], at[1] + s * u[1] + t * v[1], at[2] + s * u[2] + t * v[2]});
        break;
      }
      case Family::collinear: {
        const std::int64_t s = number(-30, 30);
        points.push_back({at[0] + s * u[0], at[1] + s * u[1], at[2] + s * u[2]});
        break;
      }
      case Family::cospherical:
        points.push_back(sphere[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(sphere.size()) - 1))]);
        break;
      case Family::repeated:
        points.push_back(
            points.empty() || number(0, 2) == 0
                ? point(size)
                : points[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(points.size()) - 1))]);
        break;
      case Family::lattice:
        points.push_back(point(2));
        break;
      case Family::layered:
        points.push_back({number(-9, 9), number(-9, 9), number(0, 1)});
        break;
    }
  }
  return points;
}

TEST(convex_hull, equals_brute_force_on_random_sets) {
  std::mt19937 random(16);
  // As they are; tiny, huge, and with subnormal coordinates: scaled by a power of two, which keeps every sign.
  const int exponents[] = {0, -400, 400, 1000, -1060, -1074};
  const int rounds = is_long_run() ? 2400 : 60;
  for (int round = 0; round < rounds; ++round)
    for (const Family family : {Family::general, Family::coplanar, Family::collinear, Family::cospherical,
                                Family::repeated, Family::lattice, Family::layered}) {
      for (const int exponent : exponents) ASSERT_TRUE(equals_brute_force(random_points(family, random), exponent));
    }
}

// Of a solid: what holds by definition, by exact signs.
void expect_convex(const std::vector<glm::dvec3>& points, const ConvexHull& hull) {
  ASSERT_EQ(hull.dimension, 3);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> facet_at;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    ASSERT_GE(facet.size(), 3u);
    ASSERT_EQ(*std::min_element(facet.begin(), facet.end()), facet[0]);
    for (std::size_t i = 0; i < facet.size(); ++i)
      ASSERT_TRUE(facet_at.emplace(std::pair(facet[i], facet[(i + 1) % facet.size()]), f).second);
    std::size_t outside = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      outside += orient3d(points[facet[0]], points[facet[1]], points[facet[2]], points[i]) > 0;
    ASSERT_EQ(outside, 0u) << "facet " << f;
    for (const std::uint32_t i : facet)
      ASSERT_EQ(orient3d(points[facet[0]], points[facet[1]], points[facet[2]], points[i]), 0);
  }
  for (const auto& [edge, f] : facet_at) {
    const auto other = facet_at.find({edge.second, edge.first});
    ASSERT_NE(other, facet_at.end());
    const auto facet = hull.facet(f);
    bool is_below = false;  // a corner of the facet beyond the edge
    for (const std::uint32_t i : hull.facet(other->second))
      is_below = is_below || orient3d(points[facet[0]], points[facet[1]], points[facet[2]], points[i]) < 0;
    ASSERT_TRUE(is_below) << "two facets in one plane";
  }
  EXPECT_EQ(hull.vertices.size() + hull.facet_count(), facet_at.size() / 2 + 2);  // Euler
}

std::vector<glm::dvec3> random_places(std::size_t count, std::mt19937& random, int kind) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<glm::dvec3> points;
  while (points.size() < count) {
    glm::dvec3 p(normal(random), normal(random), normal(random));
    const double size = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (kind == 0) p *= std::cbrt(std::abs(uniform(random))) / size;
    if (kind == 1) p /= size;
    if (kind == 2) p = {uniform(random), uniform(random), uniform(random)};
    if (kind == 3) p = glm::dvec3(glm::ivec3(p * 3.0));
    if (kind == 4 && points.size() > 4) p = {std::cos(size), std::sin(size), 0};      // a disk with a few tips
    if (kind == 5) p = {normal(random), 1 + normal(random) * 1e-13, normal(random)};  // nearly in a plane
    points.push_back(p);
  }
  return points;
}

TEST(convex_hull, holds_all_points_and_bends_at_every_edge) {
  std::mt19937 random(3);
  for (int kind = 0; kind < 6; ++kind) {
    const std::vector<glm::dvec3> points = random_places(600, random, kind);
    SCOPED_TRACE(kind);
    expect_convex(points, convex_hull(points));
  }
}

TEST(convex_hull, is_the_same_for_every_shuffle) {
  std::mt19937 random(5);
  const int inputs = is_long_run() ? 100 : 12, shuffles = is_long_run() ? 1000 : 10;
  for (int input = 0; input < inputs; ++input) {
    const std::vector<glm::dvec3> points = random_places(120, random, input % 6);
    const auto facets_of = [](const std::vector<glm::dvec3>& places) {
      const ConvexHull hull = convex_hull(places);
      const auto is_less = [](const glm::dvec3& p, const glm::dvec3& q) {
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
      };
      std::vector<std::vector<std::array<double, 3>>> facets;
      for (std::size_t f = 0; f < hull.facet_count(); ++f) {
        std::vector<glm::dvec3> corners;
        for (const std::uint32_t i : hull.facet(f)) corners.push_back(places[i] + 0.0);  // -0 becomes 0
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), is_less), corners.end());
        facets.emplace_back();
        for (const glm::dvec3& p : corners) facets.back().push_back({p.x, p.y, p.z});
      }
      std::sort(facets.begin(), facets.end());
      return facets;
    };
    const auto expected = facets_of(points);
    for (int round = 0; round < shuffles; ++round) {
      std::vector<glm::dvec3> shuffled = points;
      std::shuffle(shuffled.begin(), shuffled.end(), random);
      ASSERT_EQ(facets_of(shuffled), expected);
    }
  }
}

// A tip over a circle: every new corner of the circle is beside a fan of all others.
TEST(convex_hull, large_fans_are_found_by_sector) {
  std::vector<glm::dvec3> points{{0, 0, 3}, {0.1, 0.1, -3}};
  for (int i = 0; i < 700; ++i) points.emplace_back(std::cos(i * 0.37), std::sin(i * 0.37), std::sin(i * 0.11) * 1e-3);
  expect_convex(points, convex_hull(points));
}

TEST(convex_hull, is_cancelled) {
  std::mt19937 random(9);
  const std::vector<glm::dvec3> points = random_places(3000, random, 1);
  Progress progress([](double) { return false; });
  EXPECT_EQ(convex_hull(points, progress), ConvexHull());
  EXPECT_TRUE(progress.is_cancelled());
}

// Enough points that those inside are sifted out first.
TEST(convex_hull, is_the_same_for_every_number_of_threads) {
  for (const bool on_sphere : {false, true}) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> points;
    while (points.size() < 40000) {
      const glm::dvec3 p(normal(random), normal(random), normal(random));
      points.push_back(on_sphere ? p / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) : p);
    }
    points[7].x = std::numeric_limits<double>::infinity();
    std::optional<ConvexHull> first;
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
      const ThreadCount count(threads);
      const ConvexHull hull = convex_hull(points);
      if (!first) first = hull;
      EXPECT_EQ(hull, *first) << threads;
    }
    EXPECT_LT(first->vertices.size(), on_sphere ? points.size() : 2000u);
  }
}

}  // namespace
}  // namespace ryosen
