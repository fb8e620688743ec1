#include "ryosen/geometry/trees/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ryosen/analysis/measure/measured_surface.h"
#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/slow_distance.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen::test {
namespace {

glm::dvec3 random_point(Dice& dice) { return {dice.unit(), dice.unit(), dice.unit()}; }

std::vector<SlowTriangle> triangles_of(const TriangleTree& tree) {
  std::vector<SlowTriangle> all;
  for (std::uint32_t t = 0; t < tree.size(); ++t) all.push_back(tree.places(t));
  return all;
}

void expect_nearest(const TriangleTree& tree, const std::vector<SlowTriangle>& all, const glm::dvec3& p,
                    std::uint32_t hint, double allowed) {
  const TriangleTree::Near near = tree.nearest(p, hint);
  ASSERT_LT(near.triangle, tree.size());
  EXPECT_NEAR(near.distance, static_cast<double>(slow_distance(p, all)), allowed);
  EXPECT_NEAR(near.distance, static_cast<double>(slow_distance(p, all[near.triangle])), allowed);
}

TEST(point_triangle, is_the_shortest_way_however_thin_the_triangle) {
  Dice dice(1);
  for (int i = 0; i < 20000; ++i) {
    SlowTriangle t{random_point(dice), random_point(dice), random_point(dice)};
    const double thin = std::ldexp(1.0, -dice.below(60));
    if (dice.one_in(2)) t[1] = t[0] + thin * (t[1] - t[0]);
    if (dice.one_in(2)) t[2] = 0.5 * t[0] + 0.5 * t[1] + thin * (t[2] - t[0]);
    if (dice.one_in(9)) t[2] = t[0];
    glm::dvec3 p = random_point(dice);
    if (dice.one_in(3)) p = 0.3 * t[0] + 0.3 * t[1] + 0.4 * t[2] + thin * (p - t[0]);
    const double found = glm::length(way_from_triangle(t[0], t[1], t[2], p));
    EXPECT_NEAR(found, static_cast<double>(slow_distance(p, t)), 1e-7) << i;
    for (const glm::dvec3& corner : t) EXPECT_EQ(way_from_triangle(t[0], t[1], t[2], corner), glm::dvec3(0.0));
  }
}

TEST(triangle_tree, finds_the_nearest_of_random_triangles) {
  Dice dice(2);
  for (const std::size_t count : {1u, 2u, 4u, 5u, 16u, 17u, 63u, 300u}) {
    std::vector<glm::dvec3> positions;
    std::vector<Primitive> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
      const glm::dvec3 middle = random_point(dice);
      const double size = std::ldexp(1.0, -dice.below(8));
      for (int k = 0; k < 3; ++k) positions.push_back(middle + size * random_point(dice));
      triangles.push_back(Primitive::triangle(3 * i, 3 * i + 1, 3 * i + 2, i));
    }
    const TriangleTree tree(positions, triangles, 0.25);
    ASSERT_EQ(tree.size(), count);
    const std::vector<SlowTriangle> all = triangles_of(tree);
    for (int i = 0; i < 200; ++i) {
      const std::uint32_t hint =
          dice.one_in(2) ? no_index : static_cast<std::uint32_t>(dice.below(static_cast<int>(count)));
      const double scale = dice.one_in(4) ? 1000.0 : 0.3;
      expect_nearest(tree, all, scale * (random_point(dice) - 0.2), hint, 1e-15 * scale * 4);
    }
  }
}

TEST(triangle_tree, finds_the_nearest_on_ugly_meshes) {
  Dice dice(3);
  for (const UglyFamily& family : ugly_families()) {
    const Mesh mesh = from_indexed(family.make(120));
    const MeasuredSurface surface(mesh);
    if (surface.is_empty()) continue;
    const TriangleTree tree = surface.tree(scale_for(surface.reach()));
    const std::vector<SlowTriangle> all = triangles_of(tree);
    for (int i = 0; i < 60; ++i) {
      const SlowTriangle& t = all[static_cast<std::size_t>(dice.below(static_cast<int>(all.size())))];
      const glm::dvec3 on = 0.25 * t[0] + 0.25 * t[1] + 0.5 * t[2];
      expect_nearest(tree, all, on + std::ldexp(1.0, -dice.below(40)) * (random_point(dice) - 0.5), no_index, 1e-7);
    }
    SCOPED_TRACE(family.id);
  }
}

// Far enough away, single precision cannot tell the triangles apart.
TEST(triangle_tree, finds_the_nearest_from_afar) {
  const Mesh mesh = from_indexed(clean_grid(200));
  const MeasuredSurface surface(mesh);
  const TriangleTree tree = surface.tree(scale_for(surface.reach()));
  const std::vector<SlowTriangle> all = triangles_of(tree);
  for (const double far : {1e2, 1e5, 1e9})
    for (const glm::dvec3 to : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 2, 3), glm::dvec3(0, 0, -1)})
      expect_nearest(tree, all, far * to, no_index, 4e-16 * far * 4);
}

TEST(triangle_tree, keeps_every_triangle_with_its_owner) {
  const Mesh mesh = from_indexed(clean_grid(500));
  const MeasuredSurface surface(mesh);
  const TriangleTree tree = surface.tree(0.5);
  std::vector<int> seen(surface.triangles.size(), 0);
  for (std::uint32_t t = 0; t < tree.size(); ++t) {
    ++seen[tree.owner(t)];
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(tree.places(t)[k], 0.5 * mesh.position(Vertex(surface.triangles[tree.owner(t)].vertices[k])));
  }
  for (const int count : seen) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace ryosen::test
