// The extreme points of a hull, held against those of CGAL's with its exact predicates.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "ryosen/hull/convex_hull.h"
#include "tests/peers/point_sets.h"

namespace ryosen {
namespace {

using Place = std::array<double, 3>;

std::set<Place> extreme_places(const std::vector<glm::dvec3>& points) {
  std::set<Place> places;
  for (const std::uint32_t i : convex_hull(points).vertices) places.insert({points[i].x, points[i].y, points[i].z});
  return places;
}

std::set<Place> cgal_places(const std::vector<glm::dvec3>& points) {
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Exact::Point_3> given;
  for (const glm::dvec3& p : points) given.emplace_back(p.x, p.y, p.z);
  CGAL::Surface_mesh<Exact::Point_3> hull;
  CGAL::convex_hull_3(given.begin(), given.end(), hull);
  std::set<Place> places;
  for (const Exact::Point_3& p : hull.points()) places.insert({p.x(), p.y(), p.z()});
  return places;
}

TEST(hull_cgal, finds_the_same_extreme_points_of_random_ones) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (const bool on_sphere : {false, true})
    for (const std::size_t count : {5, 50, 500, 30000}) {  // the last ones are sifted first
      std::vector<glm::dvec3> points;
      while (points.size() < count) {
        const glm::dvec3 p(normal(random), normal(random), normal(random));
        points.push_back(on_sphere ? p / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) : p);
      }
      EXPECT_EQ(extreme_places(points), cgal_places(points)) << count << on_sphere;
    }
}

TEST(hull_cgal, finds_the_same_extreme_points_of_real_meshes) {
  const std::vector<test::PointSet> sets = test::solid_point_sets();
  EXPECT_GE(sets.size(), 10u);
  for (const test::PointSet& set : sets) EXPECT_TRUE(extreme_places(set.points) == cgal_places(set.points)) << set.name;
}

}  // namespace
}  // namespace ryosen
