// The extreme points of a hull, held against Qhull's: the same where it answers, and an answer where it gives up.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "ryosen/hull/convex_hull.h"
#include "ryosen/hull/hull_shape.h"
#include "tests/peers/point_sets.h"
#include "tests/support/core/brute_hull.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace ryosen {
namespace {

using Numbers = std::set<std::uint32_t>;

struct QhullAnswer {
  int code = 0;
  std::optional<Numbers> vertices;  // none where it ends with an error
};

QhullAnswer qhull(std::vector<glm::dvec3> points) {
  static_assert(sizeof(glm::dvec3) == 3 * sizeof(coordT));
  qhT state;
  qhT* const qh = &state;  // its macros want this name
  qh_zero(qh, stderr);
  char options[] = "qhull ";
  std::FILE* const silent = std::fopen("/dev/null", "w");
  QhullAnswer answer;
  answer.code = qh_new_qhull(qh, 3, static_cast<int>(points.size()), &points.data()->x, 0, options, silent, silent);
  if (answer.code == 0) {
    answer.vertices.emplace();
    vertexT* vertex = nullptr;
    FORALLvertices answer.vertices->insert(static_cast<std::uint32_t>(qh_pointid(qh, vertex->point)));
  }
  qh_freeqhull(qh, qh_ALL);
  int left = 0, total = 0;
  qh_memfreeshort(qh, &left, &total);
  std::fclose(silent);
  return answer;
}

Numbers ours(const std::vector<glm::dvec3>& points) {
  const ConvexHull hull = convex_hull(points);
  return {hull.vertices.begin(), hull.vertices.end()};
}

// Of equal points either may be named.
std::set<std::array<double, 3>> places_at(const std::vector<glm::dvec3>& points, const Numbers& numbers) {
  std::set<std::array<double, 3>> places;
  for (const std::uint32_t i : numbers) places.insert({points[i].x, points[i].y, points[i].z});
  return places;
}

TEST(hull_qhull, finds_the_same_extreme_points_of_random_ones) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (const bool on_sphere : {false, true})
    for (const std::size_t count : {5, 50, 500, 5000}) {
      std::vector<glm::dvec3> points;
      while (points.size() < count) {
        const glm::dvec3 p(normal(random), normal(random), normal(random));
        points.push_back(on_sphere ? p / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) : p);
      }
      EXPECT_EQ(ours(points), qhull(points).vertices) << count << on_sphere;
    }
}

// How far the farthest of these points lies outside a hull.
double farthest_outside(const std::vector<glm::dvec3>& points, const Numbers& of, const ConvexHull& hull) {
  double farthest = 0;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto corners = hull.facet(f);
    const glm::dvec3 a = points[corners[0]];
    const glm::dvec3 normal = glm::normalize(glm::cross(points[corners[1]] - a, points[corners[2]] - a));
    for (const std::uint32_t i : of) farthest = std::max(farthest, glm::dot(normal, points[i] - a));
  }
  return farthest;
}

// It takes a point that lies on its hull but for rounding for one within.
TEST(hull_qhull, finds_the_same_extreme_points_of_real_meshes_but_for_rounding) {
  int compared = 0, equal = 0;
  for (const test::PointSet& set : test::solid_point_sets()) {
    const std::vector<glm::dvec3>& points = set.points;
    const std::optional<Numbers> theirs = qhull(points).vertices;
    if (!theirs) continue;
    SCOPED_TRACE(set.name);
    ++compared;
    const Numbers own = ours(points);
    equal += places_at(points, own) == places_at(points, *theirs);
    Progress progress;
    const ConvexHull hull = hull_of_some(points, std::vector(theirs->begin(), theirs->end()), progress);
    EXPECT_EQ(places_at(points, {hull.vertices.begin(), hull.vertices.end()}), places_at(points, *theirs));
    double largest = 0;
    for (const glm::dvec3& p : points) largest = std::max(largest, glm::length(p));
    EXPECT_LE(farthest_outside(points, own, hull), 1e-8 * largest) << "slivers have no better normals";
  }
  EXPECT_GE(compared, 5);
  EXPECT_GE(equal, compared / 2);
}

// Points of whole numbers, which are exact for the oracle as for us.
using Whole = boost::multiprecision::cpp_int;
using WholePoint = test::BruteForce<Whole, Whole>::Point;

void expect_brute_force(const std::vector<glm::dvec3>& points) {
  std::vector<WholePoint> whole;
  for (const glm::dvec3& p : points) whole.push_back({Whole(p.x), Whole(p.y), Whole(p.z)});
  const test::BruteHull expected = test::BruteForce<Whole, Whole>(whole).hull();
  const ConvexHull hull = convex_hull(points);
  EXPECT_EQ(hull.dimension, expected.dimension);
  EXPECT_EQ(hull.vertices, expected.vertices);
  std::set<std::vector<std::uint32_t>> facets;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) facets.emplace(hull.facet(f).begin(), hull.facet(f).end());
  EXPECT_EQ(facets, expected.facets);
}

TEST(hull_qhull, answers_in_dimensions_where_it_gives_up) {
  const std::pair<const char*, std::vector<glm::dvec3>> cases[] = {
      {"one point", {{1, 2, 3}}},
      {"three points", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
      {"equal points", std::vector<glm::dvec3>(5, {1, 2, 3})},
      {"a line", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {5, 5, 5}}},
      {"a plane", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}},
      {"a slanted plane", {{0, 0, 0}, {3, 1, -1}, {-1, 3, 2}, {2, 4, 1}, {1, 7, 3}, {4, -2, -3}}},
  };
  for (const auto& [what, points] : cases) {
    SCOPED_TRACE(what);
    EXPECT_FALSE(qhull(points).vertices) << "so this case tells nothing any more";
    expect_brute_force(points);
  }
}

// 2^50 wide and a few units thick in one direction or two, or around the corners of a cube: about as wide as rounding.
std::vector<glm::dvec3> nearly_degenerate(int kind, std::uint64_t jitter, unsigned seed) {
  std::mt19937_64 random(seed);
  constexpr std::uint64_t wide = std::uint64_t{1} << 50;
  const auto within = [&](std::uint64_t size) { return double(random() % (2 * size + 1)) - double(size); };
  const auto corner = [&] { return (random() % 2 == 0 ? double(wide) : -double(wide)) + within(jitter); };
  std::vector<glm::dvec3> points;
  while (points.size() < 24) {
    glm::dvec3& p = points.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_thin = (kind == 1 && axis == 2) || (kind == 2 && axis > 0);
      p[axis] = kind == 0 ? corner() : within(is_thin ? jitter : wide);
    }
    if (kind == 3) p.y = std::floor(p.x * 3 / 7) + within(jitter);
  }
  return points;
}

TEST(hull_qhull, answers_where_it_gives_up_for_precision) {
  std::map<int, int> given_up;  // by the code with which it ends
  for (const auto& [kind, jitter] : {std::pair{0, 12}, {0, 24}, {1, 1}, {1, 4}, {2, 2}, {2, 4}, {3, 4}, {3, 8}})
    for (unsigned seed = 0; seed < 400; ++seed) {
      const std::vector<glm::dvec3> points = nearly_degenerate(kind, std::uint64_t(jitter), seed);
      const QhullAnswer answer = qhull(points);
      if (answer.vertices || ++given_up[answer.code] > 12) continue;
      SCOPED_TRACE(testing::Message() << "kind " << kind << " jitter " << jitter << " seed " << seed);
      expect_brute_force(points);
    }
  EXPECT_GT(given_up[qh_ERRsingular], 0) << "a flat initial simplex";
  EXPECT_GT(given_up[qh_ERRwide], 0) << "a wide facet";
  EXPECT_GT(given_up[qh_ERRtopology], 0) << "a topology that precision broke";
}

}  // namespace
}  // namespace ryosen
