// The extreme points of a hull, held against Qhull's: the same where it answers, and an answer where it gives up.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "core/hull/convex_hull.h"
#include "core/io/formats.h"
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

TEST(hull_qhull, finds_the_same_extreme_points_of_real_meshes) {
  for (const char* const name : {"/assets/stanford_bunny.obj"}) {
    const Result<MeshFile> file = read_mesh_file(std::string(RYOSEN_SOURCE_DIR) + name);
    ASSERT_TRUE(file);
    EXPECT_EQ(ours(file->mesh.positions), qhull(file->mesh.positions).vertices) << name;
  }
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
    if (kind == 0) points.emplace_back(corner(), corner(), corner());
    if (kind == 1) points.emplace_back(within(wide), within(wide), within(jitter));
    if (kind == 2) points.emplace_back(within(wide), within(jitter), within(jitter));
    if (kind == 3) {
      const double x = within(wide);
      points.emplace_back(x, std::floor(x * 3 / 7) + within(jitter), within(wide));
    }
  }
  return points;
}

TEST(hull_qhull, answers_where_it_gives_up_for_precision) {
  std::map<int, int> given_up;  // by the code with which it ends
  for (const auto& [kind, jitter] : {std::pair{0, 16}, {0, 32}, {1, 1}, {1, 4}, {2, 2}, {2, 4}, {3, 4}, {3, 8}})
    for (unsigned seed = 0; seed < 150; ++seed) {
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
