#include "core/analysis/overlap_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/build/from_indexed.h"
#include "tests/support/core/pairs_by_asking_all.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

// A solid of long and thin triangles as CAD programs write them.
struct ThinSolid {
  IndexedMesh mesh;

  std::uint32_t add_point(const glm::dvec3& p) {
    mesh.positions.push_back(p);
    return static_cast<std::uint32_t>(mesh.positions.size()) - 1;
  }
  // Points 0 .. n-1 around the axis.
  void add_ring(std::uint32_t n, double z, double waves = 0.0) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n, radius = 1.0 + waves * std::cos(3.0 * angle);
      add_point({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.corners.insert(mesh.corners.end(), {a, b, c});
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  // Turned so that nothing lies along the axes of space.
  void tilt() {
    for (glm::dvec3& p : mesh.positions)
      for (int k = 0; k < 3; ++k) {
        const int a = k, b = (k + 1) % 3;
        const double angle = 0.4 + 0.3 * k, x = p[a], y = p[b];
        p[a] = std::cos(angle) * x - std::sin(angle) * y;
        p[b] = std::sin(angle) * x + std::cos(angle) * y;
      }
  }
  void shake(Dice& dice, double by) {
    for (glm::dvec3& p : mesh.positions)
      for (int k = 0; k < 3; ++k) p[k] += by * (dice.unit() - 0.5);
  }
};

ThinSolid disc(std::uint32_t n, double waves) {
  ThinSolid solid;
  solid.add_ring(n, 0.0, waves);
  const std::uint32_t middle = solid.add_point({0.1, 0.0, 0.0});
  for (std::uint32_t i = 0; i < n; ++i) solid.add_triangle(middle, i, (i + 1) % n);
  return solid;
}

ThinSolid cone(std::uint32_t n, double waves) {
  ThinSolid solid = disc(n, waves);
  const std::uint32_t top = solid.add_point({0.0, 0.0, 2.0});
  for (std::uint32_t i = 0; i < n; ++i) solid.add_triangle(top, (i + 1) % n, i);
  return solid;
}

// Each cap a fan from a point of its rim.
ThinSolid tube(std::uint32_t n, double waves, double height) {
  ThinSolid solid;
  solid.add_ring(n, 0.0, waves);
  solid.add_ring(n, height, waves);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    solid.add_triangle(i, next, n + next);
    solid.add_triangle(i, n + next, n + i);
  }
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    solid.add_triangle(0, i + 1, i);
    solid.add_triangle(n, n + i, n + i + 1);
  }
  return solid;
}

ThinSolid cylinder(std::uint32_t n, double waves) { return tube(n, waves, 2.0); }
ThinSolid pole(std::uint32_t n, double waves) { return tube(n, waves, 50.0); }

// A square plate with a round hole, each side fans from the four corners.
ThinSolid plate(std::uint32_t n, double waves) {
  ThinSolid solid;
  for (const double z : {0.0, 1.0}) solid.add_ring(n, z, waves);
  for (const double z : {0.0, 1.0})
    for (std::uint32_t q = 0; q < 4; ++q) solid.add_point({q == 0 || q == 3 ? 3.0 : -3.0, q < 2 ? 3.0 : -3.0, z});
  for (std::uint32_t side = 0; side < 2; ++side)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = side * n + i, b = side * n + (i + 1) % n, q = 4 * i / n, next = 4 * (i + 1) / n;
      const std::uint32_t corners = 2 * n + 4 * side;
      solid.add_triangle(a, corners + q, b);
      if (next != q) solid.add_triangle(b, corners + q, corners + next % 4);
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    solid.add_triangle(i, n + i, n + (i + 1) % n);
    solid.add_triangle(i, n + (i + 1) % n, (i + 1) % n);
  }
  return solid;
}

using Shape = std::function<ThinSolid(std::uint32_t, double)>;
const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {disc, cone, cylinder, pole, plate};
  return all;
}

TEST(overlap_tree, finds_what_asking_all_pairs_finds_on_thin_solids) {
  std::size_t found = 0;
  for (std::size_t shape = 0; shape < shapes().size(); ++shape)
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Dice dice(seed);
      ThinSolid solid = shapes()[shape](static_cast<std::uint32_t>(90 + dice.below(40)), dice.one_in(2) ? 0.4 : 0.0);
      if (!dice.one_in(3)) solid.tilt();
      if (dice.one_in(2)) solid.shake(dice, dice.one_in(2) ? 0.05 : 1e-9);
      const std::vector<FacePair> expected = pairs_by_asking_all(solid.mesh);
      found += expected.size();
      ASSERT_EQ(find_self_intersections(from_indexed(std::move(solid.mesh))).pairs, expected)
          << "shape " << shape << ", seed " << seed;
    }
  EXPECT_GT(found, 1000u);
}

// Stars whose triangles run through each other, with their points on a coarse grid, so that many touch or lie in a plane
// with a tip, and places occur twice.
TEST(overlap_tree, finds_what_asking_all_pairs_finds_on_tangled_stars) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Dice dice(seed);
    const int size = 5 + dice.below(30), depth = dice.one_in(3) ? 1 : size, points = 60;
    ThinSolid solid;
    for (int i = 0; i < points; ++i) solid.add_point({dice.below(size), dice.below(size), dice.below(depth)});
    const auto any = [&] { return static_cast<std::uint32_t>(dice.below(points)); };
    while (solid.mesh.face_count() < 260) {
      const std::uint32_t a = solid.mesh.face_count() < 200 ? static_cast<std::uint32_t>(dice.below(2)) : any();
      const std::uint32_t b = any(), c = any();
      if (a != b && b != c && c != a) solid.add_triangle(a, b, c);
    }
    if (dice.one_in(3)) solid.tilt();
    const std::vector<FacePair> expected = pairs_by_asking_all(solid.mesh);
    EXPECT_GT(expected.size(), 1000u);
    ASSERT_EQ(find_self_intersections(from_indexed(std::move(solid.mesh)), expected.size(), 2).pairs, expected)
        << "seed " << seed;
  }
}

TEST(overlap_tree, tells_long_and_thin_triangles_apart) {
  for (std::size_t shape = 0; shape < shapes().size(); ++shape)
    for (const auto& [waves, is_tilted] : {std::pair(0.0, false), {0.0, true}, {0.2, false}, {0.2, true}}) {
      ThinSolid solid = shapes()[shape](2000, waves);
      if (is_tilted) solid.tilt();
      const Mesh mesh = from_indexed(std::move(solid.mesh));
      const NumberedSurface surface(mesh);
      const OverlapTree tree(surface, 1);
      std::size_t pairs = 0;
      for (std::uint32_t node = 0; node < tree.node_count(); ++node)
        tree.visit_pairs(node, [&](std::uint32_t, std::uint32_t) {
          ++pairs;
          return true;
        });
      EXPECT_LT(pairs, 16u * surface.slots())
          << "shape " << shape << ", waves " << waves << (is_tilted ? ", tilted" : "");
    }
}

}  // namespace
}  // namespace ryosen::test
