#include "ryosen/analysis/measure/distance.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "ryosen/analysis/measure/measured_surface.h"
#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/slow_distance.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using FaceLists = std::vector<std::vector<std::uint32_t>>;

IndexedMesh listed(std::vector<glm::dvec3> positions, const FaceLists& faces) {
  IndexedMesh mesh;
  mesh.positions = std::move(positions);
  for (const auto& face : faces) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

// Squares of a grid over [0, 1] x [0, 1], each cut in two, by one diagonal or by the other, at z = height(x, y).
template <class Height>
IndexedMesh grid(std::uint32_t n, bool other_diagonal, const Height& height) {
  std::vector<glm::dvec3> positions;
  FaceLists faces;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = double(i) / n, y = double(j) / n;
      positions.emplace_back(x, y, height(x, y));
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      if (other_diagonal)
        faces.insert(faces.end(), {{a, b, d}, {b, c, d}});
      else
        faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
    }
  return listed(std::move(positions), faces);
}
IndexedMesh flat_grid(std::uint32_t n, bool other_diagonal, double z) {
  return grid(n, other_diagonal, [z](double, double) { return z; });
}

IndexedMesh random_soup(Dice& dice, int count, double size) {
  std::vector<glm::dvec3> positions;
  FaceLists faces;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 middle(dice.unit(), dice.unit(), dice.unit());
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int k = 0; k < 3; ++k) positions.push_back(middle + size * glm::dvec3(dice.unit(), dice.unit(), dice.unit()));
    faces.push_back({first, first + 1, first + 2});
  }
  return listed(std::move(positions), faces);
}

std::vector<SlowTriangle> triangles_of(const IndexedMesh& mesh) {
  std::vector<SlowTriangle> all;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (std::size_t k = 2; k < mesh.face(f).size(); ++k)
      all.push_back(
          {mesh.positions[mesh.face(f)[0]], mesh.positions[mesh.face(f)[k - 1]], mesh.positions[mesh.face(f)[k]]});
  return all;
}

IndexedMesh moved(IndexedMesh mesh, double factor, const glm::dvec3& by) {
  for (glm::dvec3& p : mesh.positions) p = factor * p + by;
  return mesh;
}

SurfaceDistance measured(const IndexedMesh& a, const IndexedMesh& b,
                         const DistanceOptions& options = {.samples = 2000}) {
  Progress unseen;
  return surface_distance(from_indexed(IndexedMesh(a)), from_indexed(IndexedMesh(b)), options, unseen).value();
}

void expect_bounds_hold(const OneWayDistance& way, const SlowFigures& slow, double gap, double size) {
  EXPECT_LE(slow.largest, way.hausdorff * (1 + 1e-12));
  EXPECT_GE(slow.largest + slow.reach, way.hausdorff - way.hausdorff_gap);
  EXPECT_GE(way.hausdorff_gap, 0);
  EXPECT_LE(way.hausdorff_gap, std::max(1.01 * gap * way.hausdorff, 2e-10 * size));
  EXPECT_NEAR(glm::distance(way.from, way.to), way.hausdorff - way.hausdorff_gap, 1e-14 * size);
}

TEST(distance, equals_what_trying_everything_gives) {
  Dice dice(1);
  for (int i = 0; i < 10; ++i) {
    const double size = std::ldexp(1.0, -dice.below(4));
    const IndexedMesh a = random_soup(dice, 1 + dice.below(12), size), b = random_soup(dice, 1 + dice.below(12), size);
    const DistanceOptions options{.gap = i % 2 == 0 ? 1e-6 : 0.01, .samples = 20000};
    const SurfaceDistance found = measured(a, b, options);
    const std::vector<SlowTriangle> of_a = triangles_of(a), of_b = triangles_of(b);
    const SlowFigures forward = slow_figures(of_a, of_b, 24), backward = slow_figures(of_b, of_a, 24);
    expect_bounds_hold(found.forward, forward, options.gap, 2);
    expect_bounds_hold(found.backward, backward, options.gap, 2);
    EXPECT_NEAR(found.forward.mean, forward.mean, 5e-4) << i;
    EXPECT_NEAR(found.forward.rms, forward.rms, 5e-4) << i;
    EXPECT_NEAR(found.backward.mean, backward.mean, 5e-4) << i;
    EXPECT_NEAR(found.backward.rms, backward.rms, 5e-4) << i;
    EXPECT_EQ(found.hausdorff, std::max(found.forward.hausdorff, found.backward.hausdorff));
  }
}

bool is_same(const OneWayDistance& a, const OneWayDistance& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.mean) == bits(b.mean) && bits(a.rms) == bits(b.rms) && bits(a.hausdorff) == bits(b.hausdorff) &&
         bits(a.hausdorff_gap) == bits(b.hausdorff_gap) && a.from == b.from && a.to == b.to && a.face == b.face &&
         a.samples == b.samples && a.area == b.area;
}

TEST(distance, the_other_way_round_exchanges_the_directions) {
  Dice dice(2);
  for (int i = 0; i < 8; ++i) {
    const IndexedMesh a = random_soup(dice, 30, 0.3), b = random_soup(dice, 20, 0.5);
    const SurfaceDistance one = measured(a, b, {.samples = 3000}), other = measured(b, a, {.samples = 3000});
    EXPECT_TRUE(is_same(one.forward, other.backward));
    EXPECT_TRUE(is_same(one.backward, other.forward));
    EXPECT_EQ(one.hausdorff, other.hausdorff);
    EXPECT_NEAR(one.rms, other.rms, 1e-15);
    EXPECT_NEAR(one.mean, other.mean, 1e-15);
  }
}

TEST(distance, is_the_same_for_any_number_of_threads) {
  Dice dice(3);
  const IndexedMesh a = random_soup(dice, 300, 0.2), b = random_soup(dice, 200, 0.2);
  const SurfaceDistance one = measured(a, b, {.samples = 30000, .threads = 1});
  for (const unsigned threads : {2u, 3u, 7u}) {
    const SurfaceDistance several = measured(a, b, {.samples = 30000, .threads = threads});
    EXPECT_TRUE(is_same(one.forward, several.forward)) << threads;
    EXPECT_TRUE(is_same(one.backward, several.backward)) << threads;
  }
}

TEST(distance, of_equal_surfaces_is_nothing) {
  Dice dice(4);
  for (const IndexedMesh& mesh : {random_soup(dice, 50, 0.3), flat_grid(9, false, 0.1), random_soup(dice, 1, 1e-9)}) {
    const SurfaceDistance found = measured(mesh, mesh);
    for (const double length : {found.mean, found.rms, found.hausdorff, found.hausdorff_gap}) EXPECT_EQ(length, 0);
  }
}

TEST(distance, of_the_same_surface_cut_otherwise_is_rounding) {
  const auto slope = [](double x, double y) { return 0.3 * x - 0.2 * y; };
  for (const std::uint32_t n : {1u, 4u, 10u, 13u}) {
    const SurfaceDistance found = measured(grid(7, false, slope), grid(n, true, slope));
    EXPECT_LE(found.hausdorff, 2e-10) << n;
    EXPECT_LE(found.rms, 1e-15) << n;
  }
}

// Long triangles on fine ones, sheets far nearer to each other than either are large: each cell lies over many.
TEST(distance, has_a_tight_bound_where_surfaces_lie_along_each_other) {
  const auto plate = [](const char* more) {
    Mesh mesh = made_by("cube");
    Journal journal;
    run_algorithm(mesh, journal, "scale axis=0,0,1 factor=0.02");
    run_algorithm(mesh, journal, "subdivide scheme=midpoint steps=3");
    run_algorithm(mesh, journal, more);
    return mesh;
  };
  const Mesh coarse = plate("unite_planar"), fine = plate(is_long_run() ? "remesh length=0.05" : "remesh length=0.09"),
             apart = plate("translate by=0,0,0.001");
  Progress unheard;
  const auto along = surface_distance(coarse, fine, {}, unheard);
  EXPECT_LT(along->hausdorff, 1e-8);
  const auto shifted = surface_distance(fine, apart, {}, unheard);
  EXPECT_NEAR(shifted->hausdorff, 0.001, 1e-8);
  EXPECT_LT(shifted->hausdorff_gap, 1e-8);
}

TEST(distance, of_a_shifted_plane_is_the_shift) {
  for (const double shift : {0.25, 1e-3, 1e-7})
    for (const bool other_diagonal : {false, true})
      for (const std::uint32_t n : {5u, 8u}) {
        const SurfaceDistance found = measured(flat_grid(5, false, 0), flat_grid(n, other_diagonal, shift));
        EXPECT_NEAR(found.mean, shift, 1e-12 * shift);
        EXPECT_NEAR(found.rms, shift, 1e-12 * shift);
        EXPECT_NEAR(found.hausdorff, shift, std::max(1e-6 * shift, 2e-10));
        EXPECT_GE(found.hausdorff, shift * (1 - 1e-15));
        if (n == 5 && !other_diagonal) {
          EXPECT_NEAR(found.hausdorff, shift, 1e-15 * shift);
        }
      }
}

// A square from the quarter of it: as far as its corner in one direction, nothing in the other.
TEST(distance, tells_the_directions_apart) {
  const IndexedMesh whole = flat_grid(3, false, 0), quarter = moved(flat_grid(2, true, 0), 0.5, glm::dvec3(0.0));
  const SurfaceDistance found = measured(whole, quarter);
  EXPECT_NEAR(found.forward.hausdorff, std::sqrt(0.5), 1e-6);
  EXPECT_EQ(found.forward.from, glm::dvec3(1, 1, 0));
  EXPECT_EQ(found.forward.to, glm::dvec3(0.5, 0.5, 0));
  EXPECT_LE(found.backward.hausdorff, 2e-10);
  EXPECT_NEAR(found.diagonal, std::sqrt(2), 1e-15);
  EXPECT_NEAR(found.forward.area, 1, 1e-14);
  EXPECT_NEAR(found.backward.area, 0.25, 1e-14);
  EXPECT_NEAR(found.mean, (found.forward.mean + 0.25 * found.backward.mean) / 1.25, 1e-14);
}

// z = t x over a plane that reaches farther: t x / sqrt(1 + t t) is linear, its square quadratic.
TEST(distance, integrates_squares_over_a_plane_exactly) {
  const double t = 0.3;
  const IndexedMesh plane = moved(flat_grid(1, false, 0), 9, glm::dvec3(-4, -4, 0));
  const IndexedMesh tilted = grid(2, false, [t](double x, double) { return t * x; });
  for (const std::uint64_t samples : {1u, 100u, 5000u}) {
    const OneWayDistance way = measured(tilted, plane, {.samples = samples}).forward;
    EXPECT_GE(way.samples, std::max<std::uint64_t>(samples, 8));
    EXPECT_NEAR(way.mean, t / 2, 1e-14);
    EXPECT_NEAR(way.rms, t / std::sqrt(3), 1e-14);
  }
}

// Where the surfaces cross the distance has a kink; the error of the mean is divided by four where the spacing is
// halved.
TEST(distance, converges_with_the_second_power_of_the_spacing) {
  const double t = 0.5, zero = 0.337;
  const IndexedMesh plane = moved(flat_grid(1, false, 0), 9, glm::dvec3(-4, -4, 0));
  const IndexedMesh tilted = grid(1, false, [&](double x, double) { return t * (x - zero); });
  const double exact = t * (zero * zero + (1 - zero) * (1 - zero)) / 2;
  const auto error = [&](std::uint64_t samples) {
    return std::abs(measured(tilted, plane, {.samples = samples}).forward.mean - exact);
  };
  for (const std::uint64_t samples : {1000u, 4000u, 16000u, 64000u})
    EXPECT_LE(error(samples), 0.5 / static_cast<double>(samples)) << samples;
  EXPECT_LE(measured(tilted, plane).forward.hausdorff, t * (1 - zero) * (1 + 1e-6));
}

TEST(distance, knows_very_large_and_very_small_coordinates) {
  const IndexedMesh a = flat_grid(3, false, 0), b = flat_grid(4, true, 0.125);
  for (const double factor : {1e300, 1e150, 1e-150, 1e-300}) {
    const SurfaceDistance found = measured(moved(a, factor, glm::dvec3(0.0)), moved(b, factor, glm::dvec3(0.0)));
    EXPECT_NEAR(found.hausdorff / factor, 0.125, 1e-6);
    EXPECT_NEAR(found.rms / factor, 0.125, 1e-12);
    EXPECT_NEAR(found.diagonal / factor, std::sqrt(2), 1e-12);
  }
  for (const double factor : {1e-306, 1e-309, 1e-312, 1e-318, 5e-324}) {
    const SurfaceDistance found = measured(moved(a, factor, glm::dvec3(0.0)), moved(b, factor, glm::dvec3(0.0)));
    EXPECT_NEAR(found.hausdorff, 0.125 * factor, 2e-7 * factor + 2 * std::numeric_limits<double>::denorm_min())
        << factor;
  }
  const glm::dvec3 away(1e9, -1e9, 1e9);
  EXPECT_NEAR(measured(moved(a, 1, away), moved(b, 1, away)).hausdorff, 0.125, 1e-6);
  EXPECT_NEAR(measured(a, moved(b, 1, away)).hausdorff, std::sqrt(3) * 1e9, 10);
  const double most = std::numeric_limits<double>::max();
  const SurfaceDistance ends = measured(listed({{most, 0, 0}, {most, 1, 0}, {most, 0, 1}}, {{0, 1, 2}}),
                                        listed({{-most, 0, 0}, {-most, 1, 0}, {-most, 0, 1}}, {{0, 1, 2}}));
  EXPECT_EQ(ends.hausdorff, infinity);
}

TEST(distance, leaves_out_faces_that_are_not_finite) {
  IndexedMesh mesh = flat_grid(2, false, 0);
  mesh.positions[4].z = infinity;  // the middle one, of six triangles
  const SurfaceDistance found = measured(mesh, flat_grid(2, false, 1));
  EXPECT_EQ(found.forward.faces, 2u);
  EXPECT_EQ(found.forward.left_out, 6u);
  EXPECT_EQ(found.backward.left_out, 0u);
  EXPECT_NEAR(found.forward.hausdorff, 1, 1e-9);
  EXPECT_TRUE(has_surface(from_indexed(std::move(mesh))));
}

TEST(distance, knows_faces_without_area) {
  const IndexedMesh needle = listed({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  const IndexedMesh point = listed({{0, 3, 0}, {0, 3, 0}, {0, 3, 0}}, {{0, 1, 2}});
  const SurfaceDistance found = measured(needle, point);
  EXPECT_NEAR(found.forward.hausdorff, std::sqrt(13), 1e-5);
  EXPECT_NEAR(found.backward.hausdorff, 3, 1e-9);
  EXPECT_EQ(found.backward.mean, 3);
  EXPECT_GT(found.forward.mean, 3);
  EXPECT_LT(found.forward.mean, std::sqrt(13));
}

TEST(distance, has_nothing_to_measure_without_faces) {
  EXPECT_FALSE(has_surface(Mesh()));
  EXPECT_FALSE(has_surface(from_indexed(listed({{0, 0, 0}, {1, 0, 0}}, {}))));
  EXPECT_FALSE(has_surface(from_indexed(listed({{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}}, {{0, 1, 2}}))));
}

// Polygons count as they are drawn, whatever fans, copies and holes there are.
TEST(distance, of_every_ugly_mesh_from_a_shaken_copy_is_bounded_by_the_shaking) {
  Dice dice(5);
  for (const UglyFamily& family : ugly_families()) {
    const IndexedMesh mesh = family.make(60);
    IndexedMesh shaken = mesh;
    for (glm::dvec3& p : shaken.positions) p += 1e-3 * (glm::dvec3(dice.unit(), dice.unit(), dice.unit()) - 0.5);
    const bool is_cut_alike = family.id != "large_face" && family.id != "comb_of_holes";  // into the same triangles
    const SurfaceDistance found = measured(mesh, shaken, {.samples = 2000});
    EXPECT_GT(found.hausdorff, 0) << family.id;
    if (is_cut_alike) {
      EXPECT_LE(found.hausdorff, std::sqrt(3) * 0.5e-3 * (1 + 1e-6)) << family.id;
    }
    EXPECT_LE(found.rms, found.hausdorff) << family.id;
    EXPECT_LE(found.mean, found.rms * (1 + 1e-12)) << family.id;
  }
}

// Between two corners, whose distance is known to more digits.
TEST(distance, is_rounded_up) {
  Dice dice(11);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p(4 + dice.unit(), dice.unit(), dice.unit()), q(dice.unit(), dice.unit(), dice.unit());
    // Behind p and q, seen from the other.
    const IndexedMesh a = listed({p, p - glm::dvec3(1, 0.01, 0), p - glm::dvec3(1, 0, 0.01)}, {{0, 1, 2}});
    const IndexedMesh b = listed({q, q - glm::dvec3(1, 0.01, 0), q - glm::dvec3(1, 0, 0.01)}, {{0, 1, 2}});
    const SurfaceDistance found = measured(a, b);
    long double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const long double way = static_cast<long double>(p[axis]) - static_cast<long double>(q[axis]);
      square += way * way;
    }
    EXPECT_GE(static_cast<long double>(found.forward.hausdorff), std::sqrt(square));
    EXPECT_LE(found.forward.hausdorff, static_cast<double>(std::sqrt(square)) * (1 + 1e-5));
  }
  const IndexedMesh here = flat_grid(1, false, 0), above = flat_grid(1, false, 0.75);
  EXPECT_EQ(measured(here, above).hausdorff, 0.75) << "what is exact stays so";
}

// In a circle of n spokes a point near the middle is in the boxes of many.
TEST(distance, of_fans_asks_for_few_triangles) {
  const auto fan = [](std::uint32_t n, double height) {
    std::vector<glm::dvec3> positions{{0, 0, height}};
    FaceLists faces;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      positions.emplace_back(std::cos(angle), std::sin(angle), 0);
      faces.push_back({0, 1 + i, 1 + (i + 1) % n});
    }
    return from_indexed(listed(std::move(positions), faces));
  };
  const auto looked_at = [&](std::uint32_t n) {
    const Mesh cone = fan(n, 1);  // above the places
    const MeasuredSurface surface(cone);
    const TriangleTree tree = surface.tree(1);
    std::uint64_t count = 0;
    Dice dice(3);
    for (int i = 0; i < 400; ++i) {
      const double radius = std::pow(0.5, 4 * (0.5 + 0.5 * dice.unit())), angle = 3.2 * dice.unit();
      count += tree.triangles_asked_for({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return static_cast<double>(count) / 400;
  };
  EXPECT_LT(looked_at(2000), 40);
  EXPECT_LT(looked_at(8000), 80) << "but for those that are as near within the rounding of boxes";
}

// Two discs cut into triangles in their own ways have n * n pairs of triangles that lie above each other.
TEST(distance, of_flat_discs_cuts_few_cells_however_they_are_cut_into_triangles) {
  const auto disc = [](std::uint32_t n, double turn, bool is_fan) {
    std::vector<glm::dvec3> positions;
    FaceLists faces;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = turn + 6.283185307179586 * i / n;
      positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    if (is_fan) positions.emplace_back(0, 0, 0);
    if (!is_fan) faces.emplace_back();
    for (std::uint32_t i = 0; i < n; ++i)
      if (is_fan)
        faces.push_back({n, i, (i + 1) % n});
      else
        faces[0].push_back(i);
    return from_indexed(listed(std::move(positions), faces));
  };
  Progress none;
  for (const auto& [turn, is_fan] : {std::pair(0.0, true), std::pair(0.001, false)}) {
    std::uint64_t before = 0;
    for (const std::uint32_t n : {300u, 600u, 1200u}) {
      if (n > 600 && !is_long_run()) continue;
      const auto found =
          surface_distance(disc(n, 0, false), disc(n, turn, is_fan), DistanceOptions{.samples = 1}, none);
      const std::uint64_t cuts = found->forward.cuts + found->backward.cuts;
      EXPECT_LT(found->hausdorff_gap, 1e-9) << n;
      EXPECT_LT(cuts, 40000 + 40 * n) << n;
      if (n > 300) {
        EXPECT_LT(cuts, 2.6 * static_cast<double>(before) + 20000) << n;
      }
      before = cuts;
    }
  }
}

TEST(distance, ends_where_it_is_cancelled) {
  Dice dice(6);
  const Mesh a = from_indexed(random_soup(dice, 400, 0.2)), b = from_indexed(random_soup(dice, 400, 0.2));
  int calls = 0;
  double last = 0;
  Progress counting(
      [&](double share) {
        ++calls;
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1);
        last = share;
        return true;
      },
      Progress::Clock::duration::zero());
  ASSERT_TRUE(surface_distance(a, b, {.samples = 100000}, counting));
  EXPECT_GT(calls, 6);
  for (int stop = 1; stop <= calls; ++stop) {
    int left = stop;
    Progress cancelling([&](double) { return --left > 0; }, Progress::Clock::duration::zero());
    EXPECT_FALSE(surface_distance(a, b, {.samples = 100000}, cancelling)) << stop;
  }
}

}  // namespace
}  // namespace ryosen::test
