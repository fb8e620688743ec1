// Remeshing: what it keeps to the bit, how even the result is, and that it stays on the surface.
#include "ryosen/algo/remesh/remesh.h"
#include "ryosen/algo/algorithm_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "ryosen/algo/remesh/features.h"
#include "ryosen/algo/remesh/planar_regions.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/parallel.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

Mesh remeshed_by(const Mesh& mesh, const std::string& words) {
  Mesh made = mesh;
  Journal journal;
  const AlgorithmResult result = run_algorithm(made, journal, "remesh " + words);
  EXPECT_FALSE(result.fault) << words << ": " << result.fault->en;
  const auto broken = check_invariants(made);
  EXPECT_FALSE(broken) << broken->sentence;
  return made;
}

std::vector<double> edge_lengths(const Mesh& mesh) {
  std::vector<double> lengths;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const auto [a, b] = ends(mesh, Edge(i));
    lengths.push_back(glm::distance(mesh.position(a), mesh.position(b)));
  }
  return lengths;
}

TEST(Remesh, a_sphere_gets_even_triangles_on_the_sphere) {
  const Mesh sphere = made_by("sphere radius=1");
  for (const double length : {0.3, 0.15}) {
    const Mesh made = remeshed_by(sphere, "feature_angle=180 rounds=10 length=" + std::to_string(length));
    const Figures before = compute_figures(sphere), after = compute_figures(made);
    EXPECT_TRUE(after.closed && after.manifold);
    EXPECT_EQ(after.genus, before.genus);
    EXPECT_EQ(after.triangles, after.faces);
    EXPECT_EQ(find_self_intersections(made).count, 0u);
    EXPECT_NEAR(*after.volume, *before.volume, 0.05 * *before.volume);
    std::size_t even = 0;
    const std::vector<double> lengths = edge_lengths(made);
    for (const double l : lengths) even += l > 0.7 * length && l < 4.0 / 3 * length + 1e-9;
    EXPECT_GT(double(even), 0.9 * double(lengths.size()));
    std::size_t six = 0;
    for (std::uint32_t i = 0; i < made.vertex_slots(); ++i) {
      if (!made.is_alive(Vertex(i))) continue;
      std::uint32_t valence = 0;
      for ([[maybe_unused]] const Halfedge h : outgoing(made, Vertex(i))) ++valence;
      six += valence >= 5 && valence <= 7;
      EXPECT_LT(std::abs(glm::length(made.position(Vertex(i))) - 1), 0.05) << "on the faces of the sphere as it was";
    }
    EXPECT_GT(double(six), 0.95 * double(made.live().vertices));
  }
}

// The next point on the way from `at` straight to b; none where there is no edge along it.
Vertex next_towards(const Mesh& mesh, Vertex at, const glm::dvec3& b) {
  const glm::dvec3 here = mesh.position(at), way = b - here;
  Vertex found;
  for_each_copy(mesh, at, [&](Vertex copy) {
    if (mesh.is_isolated(copy)) return;
    for (const Vertex w : neighbours(mesh, copy)) {
      const glm::dvec3 step = mesh.position(w) - here;
      const double along = glm::dot(step, way) / glm::dot(way, way);
      if (along > 0 && along < 1 + 1e-12 && glm::length(step - along * way) < 1e-13 * glm::length(way)) found = w;
    }
  });
  return found ? point(mesh, found) : found;
}

// Of the features each point is still there to the bit, and edges of the result lead straight from end to end of each
// edge.
void expect_features_are_kept(const Mesh& before, const Mesh& after, double angle_rad) {
  Mesh triangles = before;
  Journal journal;
  run_algorithm(triangles, journal, "delaunay most_turn=0");  // cuts polygons, and swaps nothing
  const remesh::Features old = remesh::find_features(triangles, angle_rad);
  for (std::uint32_t i = 0; i < before.vertex_slots(); ++i) {
    if (!before.is_alive(Vertex(i)) || !old.vertices[i]) continue;
    ASSERT_TRUE(after.is_alive(Vertex(i))) << i;
    EXPECT_EQ(after.position(Vertex(i)), before.position(Vertex(i))) << i;
  }
  for (std::uint32_t e = 0; e < triangles.edge_slots(); ++e) {
    if (!triangles.is_alive(Edge(e)) || !old.edges[e]) continue;
    const auto [a, b] = ends(triangles, Edge(e));
    const Vertex end = point(triangles, b);
    Vertex at = point(triangles, a);
    for (int step = 0; step < 1000 && at && at != end; ++step) at = next_towards(after, at, triangles.position(b));
    EXPECT_EQ(at, end) << e;
  }
}

TEST(Remesh, features_keep_their_points_to_the_bit) {
  const Mesh cube = made_by("cube size=2");
  const Mesh made = remeshed_by(cube, "length=0.3");
  expect_features_are_kept(cube, made, 0.8);
  const Figures figures = compute_figures(made);
  EXPECT_NEAR(figures.area, 24, 1e-9);
  EXPECT_NEAR(*figures.volume, 8, 1e-9);
  EXPECT_EQ(find_self_intersections(made).count, 0u);
  for (const char* line : {"grid width=4 depth=4", "cylinder", "cone"}) {
    const Mesh shape = made_by(line);
    const Mesh other = remeshed_by(shape, "length=0.2");
    expect_features_are_kept(shape, other, 0.8);
    EXPECT_NEAR(compute_figures(other).area, compute_figures(shape).area, 0.02 * compute_figures(shape).area) << line;
    EXPECT_EQ(compute_figures(other).boundary_loops, compute_figures(shape).boundary_loops) << line;
    EXPECT_EQ(find_self_intersections(other).count, 0u) << line;
  }
}

// The points of one part of a large surface move beside those of another.
TEST(Remesh, parts_of_a_large_surface_do_not_depend_on_threads) {
  Mesh torus = made_by("torus radius=2 tube=0.7 segments=100 tube_segments=32");
  Journal journal;
  run_algorithm(torus, journal, "subdivide scheme=midpoint");
  ASSERT_GT(2 * torus.live().faces, 3u << 13) << "quads, as triangles those of more than three parts";
  std::optional<MeshColumns> alone;
  for (const unsigned threads : {1u, 3u}) {
    const ThreadCount count(threads);
    const Mesh made = remeshed_by(
        torus, is_long_run() ? "length=0.045 rounds=1 feature_angle=180" : "length=0.06 rounds=1 feature_angle=180");
    if (!alone)
      alone = made.columns();
    else
      EXPECT_EQ(made.columns(), *alone);
  }
}

TEST(Remesh, adaptive_lengths_follow_the_curvature) {
  // A torus is bent more the nearer to its tube.
  const Mesh torus = made_by("torus radius=2 tube=0.3");
  const Mesh even = remeshed_by(torus, "feature_angle=180 length=0.8"),
             adaptive = remeshed_by(torus, "feature_angle=180 length=0.8 adaptive=on tolerance=0.02");
  EXPECT_GT(adaptive.live().faces, even.live().faces);
  EXPECT_GT(compute_figures(adaptive).area, compute_figures(even).area) << "nearer to the torus";
  const double wanted = std::sqrt(6 * 0.02 * 0.3 - 3 * 0.02 * 0.02);
  std::vector<double> lengths = edge_lengths(adaptive);
  std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2), lengths.end());
  EXPECT_NEAR(lengths[lengths.size() / 2], wanted, 0.25 * wanted);
}

TEST(Remesh, any_mesh_comes_out_whole) {
  for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(3, 4), two_quads(), closed_fan(9), bow_tie(), fin(),
                                moebius_strip(), two_tetrahedra_on_an_edge(), Polygons{{0, 1, 2}},
                                Polygons{{0, 1, 2}, {0, 1, 2}}, Polygons{{0, 1, 2, 3}, {0, 1, 2, 3}}}) {
    const Mesh mesh = make_mesh(faces, 14);
    for (const char* length : {"5%", "40%", "300%"}) {
      const Mesh made = remeshed_by(mesh, std::string("length=") + length);
      expect_features_are_kept(mesh, made, std::numbers::pi / 4);
      const Figures before = compute_figures(mesh), after = compute_figures(made);
      EXPECT_EQ(after.components, before.components);
      EXPECT_EQ(after.boundary_loops, before.boundary_loops);
    }
  }
}

TEST(Remesh, the_size_of_the_mesh_does_not_matter) {
  const Mesh sphere = made_by("sphere");
  const Mesh plain = remeshed_by(sphere, "length=0.25");
  for (const double size : {0x1p-900, 0x1p900}) {
    MeshColumns scaled = sphere.columns();
    for (glm::dvec3& p : scaled.positions) p *= size;
    Progress unheard;
    const remesh::Remeshed made =
        remesh::remeshed(Mesh(scaled), {.length = 0.25 * size, .feature_angle_rad = std::numbers::pi / 4}, unheard);
    ASSERT_EQ(made.columns.positions.size(), plain.vertex_slots());
    for (std::uint32_t i = 0; i < plain.vertex_slots(); ++i)
      EXPECT_EQ(made.columns.positions[i], plain.position(Vertex(i)) * size);
  }
}

TEST(Remesh, garbage_is_refused_with_a_sentence) {
  const AlgorithmRow& row = *find_algorithm("remesh");
  for (const std::string_view word :
       {"length=0", "length=-1", "length=nan", "rounds=0", "feature_angle=200", "tolerance=0", "adaptive=perhaps"})
    EXPECT_FALSE(read_values(row.parameters, std::span(&word, 1)).values) << word;
  EXPECT_FALSE(read_values(row.parameters, {}).values) << "the length must be given";
  Mesh sphere = made_by("sphere");
  Journal journal;
  for (const char* line : {"remesh length=1e-300", "remesh length=1e-9", "remesh length=1e-5 adaptive=on"}) {
    const auto fault = run_algorithm(sphere, journal, line).fault;
    ASSERT_TRUE(fault) << line;
    const std::size_t at = fault->en.rfind(' ');
    const double shortest = std::stod(fault->en.substr(at));
    EXPECT_GT(shortest, 1e-5) << fault->en;
    EXPECT_LT(shortest, 0.1) << fault->en;
    EXPECT_NE(fault->ja.find(fault->en.substr(at + 1)), std::string::npos);
  }
  EXPECT_FALSE(run_algorithm(sphere, journal, "remesh length=1e300").fault);
  Mesh empty;
  EXPECT_TRUE(run_algorithm(empty, journal, "remesh length=1").refused);
}

// The angles across from an edge, by the law of cosines.
double angle_across(const Mesh& mesh, Halfedge h) {
  const glm::dvec3 c = mesh.position(mesh.from(mesh.prev(h)));
  const double a = glm::distance(c, mesh.position(mesh.from(h))), b = glm::distance(c, mesh.position(mesh.to(h))),
               s = glm::distance(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)));
  return std::acos(std::clamp((a * a + b * b - s * s) / (2 * a * b), -1.0, 1.0));
}

TEST(Delaunay, in_the_plane_no_circle_holds_another_point) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> aside(-0.45, 0.45);
  constexpr std::uint32_t n = 14;
  Polygons faces;
  IndexedMesh list;
  std::vector<glm::dvec3> places;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const bool is_border = x == 0 || y == 0 || x == n || y == n;
      places.emplace_back(x + (is_border ? 0 : 0.5 * aside(random)), y + (is_border ? 0 : 0.5 * aside(random)), 2);
      const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (x < n && y < n) faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
    }
  list = indexed(faces, places.size());
  list.positions = places;
  Mesh mesh = from_indexed(list);
  const double area = compute_figures(mesh).area;
  Journal journal;
  const AlgorithmResult result = run_algorithm(mesh, journal, "delaunay");
  EXPECT_GT(result.changed, 20u);
  EXPECT_EQ(result.left, 0u);
  EXPECT_NEAR(compute_figures(mesh).area, area, 1e-9);
  for (std::uint32_t i = 0; i < places.size(); ++i) EXPECT_EQ(mesh.position(Vertex(i)), places[i]);
  for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
    const Halfedge h = halfedge(Edge(e));
    if (mesh.is_outside(h) || mesh.is_outside(twin(h))) continue;
    EXPECT_LE(angle_across(mesh, h) + angle_across(mesh, twin(h)), std::numbers::pi + 1e-6);
  }
  EXPECT_EQ(run_algorithm(mesh, journal, "delaunay").changed, 0u);
}

TEST(Planar, a_cube_of_triangles_becomes_six_squares) {
  Mesh mesh = made_by("cube");
  Journal journal;
  run_algorithm(mesh, journal, "subdivide scheme=midpoint steps=3");
  const AlgorithmResult result = run_algorithm(mesh, journal, "unite_planar");
  EXPECT_EQ(result.changed, 6u);
  EXPECT_FALSE(check_invariants(mesh)) << check_invariants(mesh)->sentence;
  const Figures figures = compute_figures(mesh);
  EXPECT_EQ(figures.faces, 6u);
  EXPECT_NEAR(figures.area, 24, 1e-12);
  EXPECT_NEAR(*figures.volume, 8, 1e-12);
  EXPECT_EQ(figures.vertices, 8u + 12u * 7u) << "those on the edges stay";
}

TEST(Planar, holes_become_rings_and_materials_stay_apart) {
  Polygons faces;
  for (std::uint32_t y = 0; y < 5; ++y)
    for (std::uint32_t x = 0; x < 5; ++x) {
      const std::uint32_t a = 6 * y + x;
      if (x != 2 || y != 2) faces.push_back({a, a + 1, a + 7, a + 6});
    }
  IndexedMesh list = indexed(faces, 36);
  for (std::uint32_t i = 0; i < 36; ++i) list.positions[i] = {i % 6, i / 6, 0};
  Mesh mesh = from_indexed(list);
  const double area = compute_figures(mesh).area;
  Journal journal;
  EXPECT_EQ(run_algorithm(mesh, journal, "unite_planar").changed, 1u);
  EXPECT_FALSE(check_invariants(mesh)) << check_invariants(mesh)->sentence;
  EXPECT_EQ(mesh.live(), (ElementCounts{24, 24, 1, 1}));
  EXPECT_NEAR(compute_figures(mesh).area, area, 1e-12);
  list.materials.names = {"a", "b"};
  for (std::size_t f = 0; f < list.face_count(); ++f) list.materials.index.push_back(f < 12 ? 0 : 1);
  Mesh two = from_indexed(list);
  run_algorithm(two, journal, "unite_planar");
  EXPECT_FALSE(check_invariants(two));
  EXPECT_EQ(two.live().faces, 2u);
  EXPECT_NEAR(compute_figures(two).area, area, 1e-12);
  Mesh bent = made_by("sphere");
  EXPECT_EQ(run_algorithm(bent, journal, "unite_planar angle=0.001 distance=0").changed, 0u);
}

TEST(Planar, corners_on_straight_edges_are_dropped_where_asked) {
  Mesh box = report_mesh("box_2x2.off"), kept = box;
  Journal journal;
  run_algorithm(kept, journal, "unite_planar");
  EXPECT_EQ(kept.live().vertices, 20u);
  EXPECT_EQ(run_algorithm(box, journal, "unite_planar straight=drop").changed, 6u + 12u);
  EXPECT_FALSE(check_invariants(box)) << check_invariants(box)->sentence;
  EXPECT_EQ(box.live(), (ElementCounts{8, 12, 6, 0}));
  EXPECT_EQ(compute_figures(box).volume, 8.0);
  EXPECT_EQ(run_algorithm(box, journal, "unite_planar straight=drop").changed, 0u);
  EXPECT_EQ(run_algorithm(kept, journal, "unite_planar straight=drop").changed, 12u) << "of polygons as they are, too";
  EXPECT_EQ(kept.live(), box.live());
}

TEST(Planar, straight_corners_of_turned_scaled_and_finer_boxes_go) {
  for (const int steps : {1, 2, 4})
    for (const double size : {1.0, 1e-6, 1e6})
      for (const bool turns : {false, true}) {
        Mesh mesh = made_by("cube");
        Journal journal;
        run_algorithm(mesh, journal, "subdivide scheme=midpoint steps=" + std::to_string(steps));
        Edit edit(mesh, nullptr);
        for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
          const glm::dvec3 p = size * mesh.position(Vertex(i));
          const double c = turns ? std::cos(0.7) : 1, s = turns ? std::sin(0.7) : 0;
          edit.set_position(Vertex(i), {c * p.x - s * p.y, s * p.x + c * p.y, p.z});
        }
        edit.commit();
        run_algorithm(mesh, journal, "unite_planar straight=drop");
        EXPECT_EQ(mesh.live(), (ElementCounts{8, 12, 6, 0})) << steps << " " << size << " " << turns;
        EXPECT_FALSE(check_invariants(mesh));
      }
}

TEST(Planar, straight_corners_of_holes_and_borders_go_and_others_stay) {
  Polygons faces;
  for (std::uint32_t y = 0; y < 5; ++y)
    for (std::uint32_t x = 0; x < 5; ++x) {
      const std::uint32_t a = 6 * y + x;
      if (x < 1 || x > 3 || y < 1 || y > 3) faces.push_back({a, a + 1, a + 7, a + 6});
    }
  IndexedMesh list = indexed(faces, 36);
  for (std::uint32_t i = 0; i < 36; ++i) list.positions[i] = {i % 6, i / 6, 0};
  Mesh mesh = from_indexed(list);
  Journal journal;
  run_algorithm(mesh, journal, "unite_planar distance=0 straight=drop");
  EXPECT_FALSE(check_invariants(mesh)) << check_invariants(mesh)->sentence;
  EXPECT_EQ(compute_figures(mesh).vertices, 8u + 4u) << "corners of the border and of the hole; points in the hole";
  EXPECT_NEAR(compute_figures(mesh).area, 16, 1e-12);
  // A round border has none.
  Polygons rim(1);
  for (std::uint32_t i = 0; i < 48; ++i) rim[0].push_back(i);
  list = indexed(rim, 48);
  for (std::uint32_t i = 0; i < 48; ++i) list.positions[i] = {std::cos(i * 0.1309), std::sin(i * 0.1309), 0};
  Mesh round = from_indexed(list);
  EXPECT_EQ(run_algorithm(round, journal, "unite_planar straight=drop").changed, 0u);
}

TEST(Planar, a_long_straight_edge_loses_all_its_corners) {
  constexpr std::uint32_t length = 1000;
  Polygons faces(2);
  for (std::uint32_t i = 0; i <= length; ++i) faces[0].push_back(i);
  faces[0].push_back(length + 1);
  for (std::uint32_t i = length + 1; i-- > 0;) faces[1].push_back(i);
  faces[1].push_back(length + 2);
  IndexedMesh list = indexed(faces, length + 3);
  for (std::uint32_t i = 0; i <= length; ++i) list.positions[i] = {i, 0, 0};
  list.positions[length + 1] = {0.5 * length, 100, 3};
  list.positions[length + 2] = {0.5 * length, -100, 3};
  Mesh mesh = from_indexed(list);
  Journal journal;
  EXPECT_EQ(run_algorithm(mesh, journal, "unite_planar straight=drop").changed, length - 1);
  EXPECT_EQ(mesh.live(), (ElementCounts{4, 5, 2, 0}));
}

TEST(Planar, any_mesh_comes_out_whole) {
  for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(3, 4), two_quads(), closed_fan(9), bow_tie(), fin(),
                                moebius_strip(), two_tetrahedra_on_an_edge(), Polygons{{0, 1, 2}, {0, 1, 2}}})
    for (const char* line : {"unite_planar angle=180 distance=100", "unite_planar angle=60 distance=20%",
                             "unite_planar angle=60 distance=20% straight=drop"}) {
      Mesh mesh = make_mesh(faces);
      const std::int64_t before = compute_figures(mesh).euler_characteristic;
      Journal journal;
      run_algorithm(mesh, journal, line);
      const auto broken = check_invariants(mesh);
      EXPECT_FALSE(broken) << broken->sentence;
      EXPECT_EQ(compute_figures(mesh).euler_characteristic, before);
    }
}

}  // namespace
}  // namespace ryosen::test
