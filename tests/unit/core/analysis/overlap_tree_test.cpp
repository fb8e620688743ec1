#include "ryosen/analysis/overlap_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/long_run.h"
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

// Stars whose triangles run through each other, with their points on a coarse grid, so that many touch or lie in a
// plane with a tip, and places occur twice.
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

// Of all that find_self_intersections would ask about.
std::size_t overlapping_pairs(const Mesh& mesh) {
  const NumberedSurface surface(mesh);
  const OverlapTree tree(surface, 1);
  std::size_t pairs = 0;
  for (std::uint32_t node = 0; node < tree.node_count(); ++node)
    tree.visit_pairs(
        node, [](std::uint32_t, std::uint32_t) { return true; },
        [&](std::uint32_t, std::uint32_t) {
          ++pairs;
          return true;
        });
  return pairs;
}

// A star that winds round twice, so that its triangles meet, far too small for the numbers of the rest.
TEST(overlap_tree, finds_the_pairs_of_a_star_that_is_nothing_beside_the_rest) {
  std::size_t at = 0;
  for (const double size : {1.0, 1e-30, 1e-180, 1e-280})
    for (const double far : {1.0, 1e45, 1e300}) {
      const std::size_t each = at / 3 + at % 3;  // a short run takes each size and each distance once or twice
      if (++at; each % 3 != 0 && !is_long_run()) continue;
      constexpr std::uint32_t n = 101;
      ThinSolid solid;
      for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 4.0 * std::numbers::pi * i / n;
        solid.add_point({size * std::cos(angle), size * std::sin(angle), 0.0});
      }
      const std::uint32_t tip = solid.add_point({0.0, 0.0, 0.0});
      for (std::uint32_t i = 0; i < n; ++i) solid.add_triangle(tip, i, (i + 1) % n);
      solid.add_triangle(tip, 3, 20);  // a third of the way round, across many
      for (std::uint32_t i = 0; i < 150; ++i) {
        const double y = far * (1.0 + 0.01 * i);
        const std::uint32_t a = solid.add_point({i % 2 == 0 ? far : -far, y, far});
        solid.add_point({i % 2 == 0 ? far : -far, y + 0.005 * far, far});
        solid.add_point({i % 2 == 0 ? far : -far, y, far / 2});
        solid.add_triangle(a, a + 1, a + 2);
      }
      const std::vector<FacePair> expected = pairs_by_asking_all(solid.mesh);
      EXPECT_GT(expected.size(), n + 17);
      EXPECT_EQ(find_self_intersections(from_indexed(std::move(solid.mesh))).pairs, expected) << size << ", " << far;
    }
}

// A point out there must not make the rest so small that floats cannot tell it apart.
TEST(overlap_tree, tells_triangles_apart_beside_one_far_out) {
  constexpr std::uint32_t n = 60;
  for (const double far : {1e3, 1e10, 1e100, 1e300}) {
    ThinSolid solid;
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j) solid.add_point({i, j, 0.1 * (i * j % 7)});
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
        solid.add_triangle(a, b, b + 1);
        solid.add_triangle(a, b + 1, a + 1);
      }
    const std::uint32_t out = solid.add_point({far, 0.0, 0.0});
    solid.add_triangle(n, out, 2 * n + 1);
    const Mesh mesh = from_indexed(std::move(solid.mesh));
    EXPECT_LT(overlapping_pairs(mesh), 16u * 2 * n * n) << far;
  }
}

TEST(overlap_tree, tells_long_and_thin_triangles_apart) {
  for (std::size_t shape = 0; shape < shapes().size(); ++shape)
    for (const auto& [waves, is_tilted] : {std::pair(0.0, false), {0.0, true}, {0.2, false}, {0.2, true}}) {
      ThinSolid solid = shapes()[shape](2000, waves);
      if (is_tilted) solid.tilt();
      const Mesh mesh = from_indexed(std::move(solid.mesh));
      EXPECT_LT(overlapping_pairs(mesh), 16u * mesh.face_slots())
          << "shape " << shape << ", waves " << waves << (is_tilted ? ", tilted" : "");
    }
}

// Cups in each other, each a closed shell with walls inside and outside, that grow from one to the next.
ThinSolid cups(std::uint32_t count, std::uint32_t sides, double growth) {
  constexpr double apart = 0.01;
  ThinSolid solid;
  for (std::uint32_t s = 0; s < count; ++s) {
    const double radius = 1 + growth * s, height = 2 * radius, bottom = growth > 0 ? -0.1 * apart * s : apart * s;
    const std::uint32_t tip = solid.add_point({0, 0, bottom + height});
    solid.add_point({0, 0, bottom + height - 0.5 * apart});
    for (const double r : {radius, radius * (1 - 0.5 * apart / height)})
      for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        solid.add_point({r * std::cos(angle), r * std::sin(angle), bottom});
      }
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = tip + 2 + i, b = tip + 2 + (i + 1) % sides, c = a + sides, d = b + sides;
      solid.add_triangle(tip, a, b);
      solid.add_triangle(tip + 1, d, c);
      solid.add_triangle(a, c, d);
      solid.add_triangle(a, d, b);
    }
  }
  return solid;
}

TEST(overlap_tree, finds_what_asking_all_pairs_finds_in_stacked_cups) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Dice dice(seed);
    const auto sides = static_cast<std::uint32_t>(5 + dice.below(8));
    ThinSolid solid = cups(20, sides, dice.one_in(2) ? 0.02 : 0.0);
    if (dice.one_in(2)) solid.tilt();
    solid.shake(dice, dice.one_in(2) ? 0.01 : 0.004);
    const std::vector<FacePair> expected = pairs_by_asking_all(solid.mesh);
    found += expected.size();
    const Mesh mesh = from_indexed(std::move(solid.mesh));
    ASSERT_EQ(find_self_intersections(mesh).pairs, expected) << "seed " << seed;
    ASSERT_EQ(find_self_intersections(mesh, expected.size(), 2).pairs, expected) << "seed " << seed;
  }
  EXPECT_GT(found, 1000u);
}

// Not as the pairs of cups, of which all boxes overlap.
TEST(overlap_tree, overlaps_in_stacked_cups_grow_little_faster_than_their_number) {
  const std::uint32_t few = is_long_run() ? 40 : 24;
  for (const double growth : {0.0, 0.02}) {
    const std::size_t of_few = overlapping_pairs(from_indexed(cups(few, 12, growth).mesh)),
                      of_many = overlapping_pairs(from_indexed(cups(4 * few, 12, growth).mesh));
    EXPECT_LT(of_many, 9 * of_few) << growth << ": " << of_few << " and " << of_many;
  }
}

}  // namespace
}  // namespace ryosen::test
