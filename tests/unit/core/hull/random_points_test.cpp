#include "ryosen/hull/random_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "ryosen/hull/convex_hull.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen {
namespace {

__extension__ using Wide = __int128;

TEST(random_points, lie_where_their_family_says_and_depend_on_the_seed) {
  for (const PointFamilyRow& row : point_families()) {
    SCOPED_TRACE(row.id);
    const std::vector<glm::dvec3> points = random_points(row.family, 700, 3);
    ASSERT_EQ(points.size(), 700u);
    EXPECT_EQ(points, random_points(row.family, 700, 3));
    EXPECT_EQ(points == random_points(row.family, 700, 4), row.family == PointFamily::grid);
    std::set<double> coordinates;
    for (const glm::dvec3& p : points) {
      const double size = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
      for (int axis = 0; axis < 3; ++axis) {
        coordinates.insert(p[axis]);
        EXPECT_LE(std::abs(p[axis]), 1);
      }
      if (row.family == PointFamily::ball) {
        EXPECT_LE(size, 1);
      }
      if (row.family == PointFamily::sphere) {
        EXPECT_NEAR(size, 1, 1e-15);
      }
      if (row.family != PointFamily::cospherical) continue;
      const auto whole = [](double value) { return static_cast<Wide>(value * 0x1p18); };
      EXPECT_EQ(static_cast<double>(whole(p.x)) * 0x1p-18, p.x) << "a whole number of units";
      EXPECT_TRUE(whole(p.x) * whole(p.x) + whole(p.y) * whole(p.y) + whole(p.z) * whole(p.z) ==
                  static_cast<Wide>(255255) * 255255);
    }
    const bool is_regular = row.family == PointFamily::grid || row.family == PointFamily::lattice;
    EXPECT_EQ(coordinates.size() == 9, is_regular);
    const ConvexHull hull = convex_hull(points);
    const std::set<std::tuple<double, double, double>> places = [&] {
      std::set<std::tuple<double, double, double>> all;
      for (const glm::dvec3& p : points) all.emplace(p.x, p.y, p.z);
      return all;
    }();
    EXPECT_EQ(places.size() < points.size(), row.family == PointFamily::lattice);
    if (row.family == PointFamily::cospherical) {
      EXPECT_EQ(hull.vertices.size(), places.size());
    }
    if (row.family == PointFamily::grid) {
      EXPECT_LT(hull.facet_count(), 20u);
    }
  }
}

TEST(random_points, are_a_primitive) {
  Mesh mesh;
  Journal journal;
  const AlgorithmResult result = test::run_algorithm(mesh, journal, "points cube count=50 radius=3 at=10,0,0");
  EXPECT_EQ(result.changed, 50u);
  EXPECT_EQ(mesh.live().vertices, 50u);
  for (std::uint32_t v = 0; v < 50; ++v) EXPECT_NEAR(mesh.position(Vertex(v)).x, 10, 3);
  EXPECT_TRUE(test::run_algorithm(mesh, journal, "points radius=1e308 at=1e308,0,0").fault);
  journal.undo(mesh);
  EXPECT_EQ(mesh.live().vertices, 0u);
}

}  // namespace
}  // namespace ryosen
