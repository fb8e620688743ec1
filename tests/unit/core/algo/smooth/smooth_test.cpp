// Smoothing against closed forms: waves on a closed grid, symmetric solids, cylinders, planes.
#include "ryosen/algo/smooth/smooth.h"
#include "ryosen/algo/algorithm_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "ryosen/analysis/figures.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

using smooth::BoundaryRule;
using smooth::Method;
using smooth::WeightKind;

constexpr double turn = 2 * std::numbers::pi;

Mesh placed(const Polygons& faces, const std::vector<glm::dvec3>& places) {
  IndexedMesh list = indexed(faces, places.size());
  list.positions = places;
  return from_indexed(list);
}

std::vector<glm::dvec3> smoothed_places(const Mesh& mesh, const smooth::Options& options,
                                        std::vector<double> shares = {}) {
  Progress unheard;
  if (shares.empty()) shares.assign(mesh.vertex_slots(), 1.0);
  return smooth::smoothed(mesh, options, shares, unheard).places;
}

// On a grid that closes both ways each wave is multiplied by a number of its own in every step.
TEST(Smooth, waves_on_a_closed_grid_fade_by_their_frequency) {
  constexpr std::uint32_t rows = 12, columns = 16;
  for (const auto& [k, l] : std::vector<std::pair<int, int>>{{1, 0}, {0, 2}, {3, 1}, {8, 6}}) {
    std::vector<glm::dvec3> places;
    for (std::uint32_t r = 0; r < rows; ++r)
      for (std::uint32_t c = 0; c < columns; ++c) {
        const double angle = turn * (double(k * int(c)) / columns + double(l * int(r)) / rows);
        places.emplace_back(std::cos(angle), std::sin(angle), 3);
      }
    const Mesh mesh = placed(torus_grid(rows, columns), places);
    const double a = turn * k / columns, b = turn * l / rows;  // its squares have a diagonal
    const double frequency = 1 - (std::cos(a) + std::cos(b) + std::cos(a + b)) / 3;
    const auto expect = [&, name = std::to_string(k) + " " + std::to_string(l)](const smooth::Options& options,
                                                                                double factor) {
      const std::vector<glm::dvec3> after = smoothed_places(mesh, options);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 wanted(factor * places[i].x, factor * places[i].y, 3);
        EXPECT_LT(glm::distance(after[i], wanted), 1e-10) << name;
      }
    };
    const smooth::Options uniform{.weights = WeightKind::uniform, .steps = 5, .strength = 0.4};
    expect(uniform, std::pow(1 - 0.4 * frequency, 5));
    smooth::Options implicit = uniform;
    implicit.method = Method::implicit;
    implicit.strength = 20;
    expect(implicit, std::pow(1 + 20 * frequency, -5));
    smooth::Options taubin = uniform;
    taubin.method = Method::taubin;
    const double back = 1 / (0.1 - 1 / 0.4);
    expect(taubin, std::pow((1 - 0.4 * frequency) * (1 - back * frequency), 5));
  }
}

// All vertices are alike, so they move towards the middle by the same factor, whatever the weights.
TEST(Smooth, regular_solids_shrink_towards_their_middle) {
  const Mesh solid = made_by("icosahedron");
  const double factor = 1 - 0.5 * (1 - 1 / std::sqrt(5.0));  // the cosine between two of its neighbours
  for (const WeightKind weights : {WeightKind::uniform, WeightKind::cotangent}) {
    const std::vector<glm::dvec3> after = smoothed_places(solid, {.weights = weights, .steps = 3});
    for (std::uint32_t i = 0; i < after.size(); ++i)
      EXPECT_LT(glm::distance(after[i], std::pow(factor, 3) * solid.position(Vertex(i))), 1e-13);
    const std::vector<glm::dvec3> kept = smoothed_places(solid, {.weights = weights, .steps = 3, .keeps_volume = true});
    for (std::uint32_t i = 0; i < kept.size(); ++i)
      EXPECT_LT(glm::distance(kept[i], solid.position(Vertex(i))), 1e-13) << "a closed one comes back";
  }
}

// n sides of length s, rows of height h: the sides weigh h / s, the rows s / h.
TEST(Smooth, a_cylinder_shrinks_by_its_curvature) {
  constexpr std::uint32_t n = 24, rows = 9;
  const double height = 0.3, side = 2 * std::sin(turn / 2 / n);
  std::vector<glm::dvec3> places;
  Polygons faces;
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < n; ++c) {
      places.emplace_back(std::cos(turn * c / n), std::sin(turn * c / n), height * r);
      const std::uint32_t a = r * n + c, b = r * n + (c + 1) % n;
      if (r + 1 < rows) faces.insert(faces.end(), {{a, b, b + n}, {a, b + n, a + n}});
    }
  const Mesh mesh = placed(faces, places);
  const std::vector<glm::dvec3> after = smoothed_places(mesh, {.steps = 1, .strength = 0.8});
  const double around = height / side, along = side / height;
  const double radius = 1 - 0.8 * around * (1 - std::cos(turn / n)) / (around + along);
  for (std::uint32_t i = 0; i < after.size(); ++i) {
    const bool is_inside = i >= n && i < (rows - 1) * n;
    const double scale = is_inside ? radius : 1;
    EXPECT_LT(glm::distance(after[i], places[i] * glm::dvec3(scale, scale, 1)), 1e-13) << i;
  }
}

std::vector<glm::dvec3> uneven_grid(std::uint32_t n, Polygons& faces) {
  std::vector<glm::dvec3> places;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> aside(-0.15, 0.15);
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const bool on_x = x == 0 || x == n, on_y = y == 0 || y == n;
      places.emplace_back(x + (on_x ? 0 : aside(random)), y + (on_y ? 0 : aside(random)), 0.0);
      const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (x < n && y < n) faces.insert(faces.end(), {{a, b, d}, {b, c, d}});
    }
  return places;
}

TEST(Smooth, boundaries_stay_slide_or_move) {
  Polygons faces;
  constexpr std::uint32_t n = 8;
  const std::vector<glm::dvec3> places = uneven_grid(n, faces);
  const Mesh mesh = placed(faces, places);
  const auto is_on_border = [&](const glm::dvec3& p) { return p.x == 0 || p.y == 0 || p.x == n || p.y == n; };
  for (const Method method : {Method::laplace, Method::implicit, Method::taubin}) {
    for (const BoundaryRule rule : {BoundaryRule::locked, BoundaryRule::sliding, BoundaryRule::free}) {
      const std::vector<glm::dvec3> after =
          smoothed_places(mesh, {.method = method, .weights = WeightKind::uniform, .boundary = rule, .steps = 200});
      std::size_t moved = 0;
      double area = 0;
      for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(after[i].z, 0);
        if (!is_on_border(places[i])) continue;
        moved += after[i] != places[i];
        if (rule == BoundaryRule::sliding) {
          EXPECT_TRUE(is_on_border(after[i])) << "on the straight lines";
        }
      }
      for (const std::vector<std::uint32_t>& f : faces)
        area += glm::cross(after[f[1]] - after[f[0]], after[f[2]] - after[f[0]]).z / 2;
      EXPECT_EQ(moved > 0, rule != BoundaryRule::locked);
      if (rule != BoundaryRule::free) {
        EXPECT_NEAR(area, n * n, 1e-9) << int(method) << int(rule);
      }
      if (rule == BoundaryRule::sliding && method == Method::laplace) {  // evenly spread in the end
        for (std::uint32_t x = 0; x <= n; ++x) EXPECT_LT(glm::distance(after[x], glm::dvec3(x, 0, 0)), 1e-4);
      }
    }
  }
}

// Of a disc whose boundary is a loop of uneven edges, and of one in which two points of it are held by sharp corners.
TEST(Smooth, sliding_points_stay_on_the_curve_that_the_boundary_was) {
  constexpr std::uint32_t n = 24;
  for (const bool has_corners : {false, true}) {
    Polygons faces;
    std::vector<glm::dvec3> places;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = (i + 0.3 * std::sin(5.0 * i)) * 2 * std::numbers::pi / n;
      const bool is_corner = has_corners && i % 12 == 0;
      places.emplace_back((is_corner ? 1.5 : 1.0) *
                          glm::dvec3(std::cos(angle), std::sin(angle), 0.2 * std::cos(2 * angle)));
      faces.push_back({n, i, (i + 1) % n});
    }
    places.emplace_back(0, 0, 0);
    const Mesh mesh = placed(faces, places);
    for (const Method method : {Method::laplace, Method::implicit, Method::taubin}) {
      const std::vector<glm::dvec3> after =
          smoothed_places(mesh, {.method = method, .boundary = BoundaryRule::sliding, .steps = 300});
      const auto way = [&](std::size_t i) { return glm::distance(after[i], after[(i + 1) % n]); };
      for (std::size_t i = 0; i < n; ++i) {
        double least = 1;
        for (std::size_t k = 0; k < n; ++k) {
          const glm::dvec3 &a = places[k], along = places[(k + 1) % n] - a;
          const double t = std::clamp(glm::dot(after[i] - a, along) / glm::dot(along, along), 0.0, 1.0);
          least = std::min(least, glm::distance(after[i], a + t * along));
        }
        EXPECT_LT(least, 1e-14) << i << " " << int(method);
        if (has_corners && i % 12 == 0) {
          EXPECT_EQ(after[i], places[i]);
        }
        if (!has_corners && method == Method::laplace) {
          EXPECT_NEAR(way(i), way((i + 1) % n), 0.01) << "evenly in the end";
        }
      }
    }
  }
}

TEST(Smooth, points_beside_one_that_is_nowhere_do_not_slide) {
  constexpr std::uint32_t n = 24;
  Polygons faces;
  std::vector<glm::dvec3> places;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = (i + 0.3 * std::sin(5.0 * i)) * 2 * std::numbers::pi / n;
    places.emplace_back(std::cos(angle), std::sin(angle), 0);
    faces.push_back({n, i, (i + 1) % n});
  }
  places.emplace_back(0, 0, 0);
  places[7].x = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec3> after =
      smoothed_places(placed(faces, places), {.boundary = BoundaryRule::sliding, .steps = 20});
  for (std::uint32_t i = 0; i < n; ++i) {
    if (i == 7) continue;
    EXPECT_TRUE(is_finite(after[i])) << i;
    EXPECT_EQ(after[i] == places[i], i == 6 || i == 8) << i;
  }
}

// What is linear over the plane has no curvature: with cotangents nothing there moves, however uneven the triangles.
TEST(Smooth, by_cotangents_a_plane_stays_as_it_is) {
  Polygons faces;
  const std::vector<glm::dvec3> places = uneven_grid(8, faces);
  Mesh mesh = placed(faces, places);
  Journal journal;
  run_algorithm(mesh, journal, "delaunay");  // so that no weight is negative
  for (const Method method : {Method::laplace, Method::implicit}) {
    const std::vector<glm::dvec3> after = smoothed_places(mesh, {.method = method, .steps = 3});
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_LT(glm::distance(after[i], places[i]), 1e-10);
    const std::vector<glm::dvec3> uniform =
        smoothed_places(mesh, {.method = method, .weights = WeightKind::uniform, .steps = 3});
    double most = 0;
    for (std::size_t i = 0; i < places.size(); ++i) most = std::max(most, glm::distance(uniform[i], places[i]));
    EXPECT_GT(most, 0.01);
  }
}

TEST(Smooth, shares_and_the_volume_of_each_part) {
  Mesh mesh = made_by("sphere");
  Journal journal;
  run_algorithm(mesh, journal, "cube at=9,0,0");
  run_algorithm(mesh, journal, "grid at=0,0,9");
  const Figures before = compute_figures(mesh);
  const Mesh kept = mesh;
  const AlgorithmResult all =
      run_algorithm(mesh, journal, "smooth steps=5 weights=uniform keep_volume=on boundary=free");
  EXPECT_NE(all.text.en.find("2 parts kept their volume; one part has no volume"), std::string::npos) << all.text.en;
  Mesh closed = made_by("sphere");
  run_algorithm(closed, journal, "cube at=9,0,0");
  const double volume = *compute_figures(closed).volume;
  run_algorithm(closed, journal, "smooth steps=5 keep_volume=on");
  EXPECT_NEAR(*compute_figures(closed).volume, volume, 1e-12 * volume);
  run_algorithm(closed, journal, "smooth steps=5");
  EXPECT_LT(*compute_figures(closed).volume, 0.99 * volume);
  // One vertex alone, and then those around it too, but less.
  Mesh one = kept;
  EXPECT_EQ(run_algorithm(one, journal, "smooth steps=1 select=v0").changed, 1u);
  Mesh some = kept;
  EXPECT_GT(run_algorithm(some, journal, "smooth steps=1 select=v0 falloff=0.5").changed, 3u);
  EXPECT_EQ(one.position(Vertex(0)), some.position(Vertex(0)));
  EXPECT_EQ(before.vertices, compute_figures(mesh).vertices);
}

TEST(Smooth, gives_the_volume_back_exactly_or_says_that_it_cannot) {
  struct Case {
    const char* shape;
    const char* line;
  };
  for (const Case& one : {Case{"cube", "smooth keep_volume=on"}, Case{"cube", "smooth keep_volume=on steps=1"},
                          Case{"cube", "smooth keep_volume=on steps=100 strength=1 weights=uniform"},
                          Case{"sphere", "smooth keep_volume=on steps=1000 strength=1 weights=uniform"},
                          Case{"sphere", "smooth keep_volume=on method=implicit strength=1e12 steps=3"},
                          Case{"sphere", "smooth keep_volume=on method=taubin steps=40"},
                          Case{"torus", "smooth keep_volume=on steps=20"}}) {
    Mesh mesh = made_by(one.shape);
    Mesh alone = mesh;
    Journal journal;
    const double volume = *compute_figures(mesh).volume;
    const AlgorithmResult result = run_algorithm(mesh, journal, one.line);
    const double after = *compute_figures(mesh).volume;
    if (result.text.en.find("one part kept its volume") != std::string::npos) {
      EXPECT_NEAR(after, volume, 1e-9 * volume) << one.shape << " " << one.line;
      continue;
    }
    EXPECT_NE(result.text.en.find("one part could not get its volume back"), std::string::npos) << result.text.en;
    std::string without = one.line;
    without.erase(without.find(" keep_volume=on"), 15);
    run_algorithm(alone, journal, without);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
      EXPECT_EQ(mesh.position(Vertex(i)), alone.position(Vertex(i))) << one.shape << " " << one.line;
  }
  Mesh cube = made_by("cube");
  Journal journal;
  EXPECT_NE(run_algorithm(cube, journal, "smooth keep_volume=on").text.en.find("kept its volume"), std::string::npos);
}

TEST(Smooth, copies_and_what_is_not_finite_stay) {
  for (const Polygons& faces : {fin(), bow_tie(), moebius_strip(), two_tetrahedra_on_an_edge(), Polygons{{0, 1, 2}}}) {
    Mesh mesh = make_mesh(faces);
    for (const char* line :
         {"smooth boundary=free", "smooth boundary=free method=implicit", "smooth boundary=sliding"}) {
      Mesh after = mesh;
      Journal journal;
      run_algorithm(after, journal, line);
      for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
        if (has_copies(mesh, Vertex(i))) {
          EXPECT_EQ(after.position(Vertex(i)), mesh.position(Vertex(i)));
        }
    }
  }
  Mesh sphere = made_by("sphere");
  MeshColumns columns = sphere.columns();
  columns.positions[20].x = std::nan("");
  const Mesh broken(columns);
  for (const Method method : {Method::laplace, Method::implicit, Method::taubin}) {
    const std::vector<glm::dvec3> after = smoothed_places(broken, {.method = method});
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(i == 20, std::isnan(after[i].x)) << i;
  }
}

TEST(Smooth, the_size_of_the_mesh_does_not_matter) {
  const Mesh sphere = made_by("sphere");
  for (const Method method : {Method::laplace, Method::implicit, Method::taubin}) {
    const smooth::Options options{.method = method, .steps = 3, .keeps_volume = true};
    const std::vector<glm::dvec3> plain = smoothed_places(sphere, options);
    for (const double size : {0x1p-900, 0x1p900}) {
      MeshColumns scaled = sphere.columns();
      for (glm::dvec3& p : scaled.positions) p *= size;
      const std::vector<glm::dvec3> after = smoothed_places(Mesh(scaled), options);
      for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(after[i], plain[i] * size);
    }
  }
}

TEST(Smooth, garbage_is_refused_with_a_sentence) {
  const AlgorithmRow& row = *find_algorithm("smooth");
  for (const std::string_view word : {"steps=0", "steps=-3", "steps=nan", "steps=1e300", "strength=0", "strength=-1",
                                      "strength=nan", "strength=1e300", "pass_band=0", "falloff=-1", "method=magic"})
    EXPECT_FALSE(read_values(row.parameters, std::span(&word, 1)).values) << word;
  Mesh sphere = made_by("sphere");
  Journal journal;
  EXPECT_TRUE(run_algorithm(sphere, journal, "smooth strength=2").fault);
  EXPECT_TRUE(run_algorithm(sphere, journal, "smooth method=taubin strength=1 pass_band=1").fault);
  EXPECT_FALSE(run_algorithm(sphere, journal, "smooth method=implicit strength=2").fault);
  Mesh empty;
  EXPECT_TRUE(run_algorithm(empty, journal, "smooth").refused);
}

}  // namespace
}  // namespace ryosen::test
