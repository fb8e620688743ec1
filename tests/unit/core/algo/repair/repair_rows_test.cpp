#include "ryosen/algo/algorithm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/report.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/algorithm_input.h"
#include "tests/support/core/open_shapes.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

AlgorithmResult run_repair(Mesh& mesh, std::string_view id, std::optional<double> number = {}) {
  Edit edit(mesh, nullptr);
  Progress unheard;
  const AlgorithmResult result = find_algorithm(id)->run(edit, input_of(*find_algorithm(id), number), unheard);
  edit.commit();
  return result;
}

// A cube of six quads that share no point.
IndexedMesh loose_cube() {
  IndexedMesh source = indexed(cube()), loose;
  for (std::uint32_t i = 0; i < 8; ++i) source.positions[i] = {i & 1u, i >> 1 & 1u, i >> 2};
  for (std::uint32_t corner : source.corners) {
    loose.corners.push_back(static_cast<std::uint32_t>(loose.positions.size()));
    loose.positions.push_back(source.positions[corner]);
  }
  loose.face_offsets = source.face_offsets;
  return loose;
}

TEST(repairs, welding_makes_loose_faces_a_solid) {
  Mesh mesh = from_indexed(loose_cube());
  const AlgorithmResult result = run_repair(mesh, "weld_equal");
  EXPECT_EQ(result.changed, 16u);
  EXPECT_EQ(result.left, 0u);
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed && figures.manifold);
  EXPECT_EQ(figures.vertices, 8u);
  EXPECT_EQ(figures.volume, 1.0);
}

TEST(repairs, two_cubes_at_one_edge_stay_two_solids) {
  IndexedMesh two = loose_cube();
  const std::size_t corners = two.corners.size();
  for (std::size_t i = 0; i < corners; ++i) {
    two.corners.push_back(static_cast<std::uint32_t>(two.positions.size()));
    two.positions.push_back(two.positions[two.corners[i]] + glm::dvec3(1, 1, 0));
    if ((i + 1) % 4 == 0) two.face_offsets.push_back(static_cast<std::uint32_t>(two.corners.size()));
  }
  Mesh mesh = from_indexed(two);
  EXPECT_EQ(run_repair(mesh, "weld_equal").left, 2u) << "the ends of the common edge";
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::nonmanifold_edge], 0u);
  Mesh other = from_indexed(two);
  EXPECT_EQ(run_repair(other, "weld_close", 0.0).left, 2u);
  EXPECT_EQ(compute_figures(other)[ProblemKind::nonmanifold_edge], 0u) << "nor does welding close points";
}

TEST(repairs, two_cubes_on_the_points_of_one_edge_come_apart) {
  IndexedMesh two = indexed(cube());
  for (std::uint32_t i = 0; i < 8; ++i) two.positions[i] = {i & 1u, i >> 1 & 1u, i >> 2};
  const std::vector<std::uint32_t> corners = two.corners;
  for (std::uint32_t i = 0; i < 8; ++i) two.positions.push_back(two.positions[i] + glm::dvec3(1, 1, 0));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t c = corners[i];
    two.corners.push_back((c & 3u) == 0 ? c + 3 : c + 8);  // its edge at (1, 1) is that of the first cube
    if ((i + 1) % 4 == 0) two.face_offsets.push_back(static_cast<std::uint32_t>(two.corners.size()));
  }
  Mesh mesh = from_indexed(two);
  ASSERT_EQ(compute_figures(mesh)[ProblemKind::nonmanifold_edge], 1u);
  EXPECT_EQ(run_repair(mesh, "detach_nonmanifold").changed, 2u);
  const Figures apart = compute_figures(mesh);
  EXPECT_TRUE(apart.manifold && apart.closed);
  EXPECT_EQ(apart.components, 2u);
}

TEST(repairs, a_flat_face_within_a_disc_goes_without_a_hole) {
  // A fan of six around vertex 0 in which 0, 1 and 2 lie on a line, the flat face 0-1-2 included; across its long side
  // 0-2 lies the flat face 0-2-3.
  IndexedMesh disc = indexed({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 6}, {1, 6, 2}, {2, 6, 3}});
  disc.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 3, 0}, {-3, -3, 0}, {3, -3, 0}};
  Mesh mesh = from_indexed(disc);
  const Figures before = compute_figures(mesh);
  ASSERT_EQ(before[ProblemKind::degenerate_area], 2u);
  run_repair(mesh, "remove_degenerate");
  const Figures after = compute_figures(mesh);
  EXPECT_EQ(after[ProblemKind::degenerate_area], 0u);
  EXPECT_EQ(after.boundary_loops, before.boundary_loops);
  EXPECT_TRUE(after.manifold);
}

TEST(repairs, equal_triangles_that_run_alike_are_not_turned_into_a_hanging_pair) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 2, 0}});
  EXPECT_EQ(run_repair(mesh, "orient").changed, 0u);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::hanging_pair], 0u);
}

TEST(repairs, duplicates_go_without_a_misoriented_edge) {
  // Two triangles that run their common edge alike, and one of them again: the edge has three faces.
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 1, 3}, {1, 3, 0}});
  ASSERT_EQ(compute_figures(mesh)[ProblemKind::misoriented_edge], 2u)
      << "the other edges of the face that is there twice";
  EXPECT_EQ(run_repair(mesh, "remove_duplicates").changed, 1u);
  const Figures after = compute_figures(mesh);
  EXPECT_EQ(after[ProblemKind::misoriented_edge], 0u);
  EXPECT_TRUE(after.manifold);
}

TEST(repairs, two_faces_back_to_back_are_a_closed_part_and_stay) {
  // On an edge of a third, alone, and as both sides of a sheet.
  for (const Polygons& faces : {Polygons{{0, 1, 2}, {0, 1, 3}, {0, 3, 1}}, Polygons{{0, 1, 2}, {2, 1, 0}},
                                Polygons{{0, 1, 2, 3}, {1, 0, 4, 5}, {3, 2, 1, 0}, {5, 4, 0, 1}}}) {
    Mesh mesh = make_mesh(faces);
    const AlgorithmResult result = run_repair(mesh, "remove_duplicates");
    EXPECT_EQ(result.changed, 0u);
    ASSERT_GT(result.left, 0u);
    EXPECT_EQ(result.left_for[0].reason.en, "it bounds a closed part, as the face on its points does");
    EXPECT_EQ(result.left, compute_figures(mesh)[ProblemKind::duplicate_face]);
  }
}

TEST(repairs, a_fan_of_many_faces_that_has_two_sides_comes_apart_at_once) {
  constexpr std::uint32_t n = 16000;  // in the order around the apex it takes 18 s
  Polygons faces = closed_fan(n);
  for (std::uint32_t i = 0; i < n; ++i) faces.push_back({0, 1 + (i + 1) % n, 1 + i});
  IndexedMesh source = indexed(faces);
  for (std::uint32_t i = 1; i <= n; ++i)
    source.positions[i] = {std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 1};
  Mesh mesh = from_indexed(source);
  run_repair(mesh, "detach_nonmanifold");
  const Figures after = compute_figures(mesh);
  EXPECT_TRUE(after.closed && after.manifold);
  EXPECT_EQ(after.vertices, n + 2) << "the rim, and an apex for each side";
}

TEST(repairs, close_points_join_the_first_and_take_its_place) {
  IndexedMesh loose = loose_cube();
  for (std::size_t i = 0; i < loose.positions.size(); ++i) loose.positions[i].x += 1e-6 * static_cast<double>(i);
  Mesh mesh = from_indexed(loose);
  EXPECT_EQ(run_repair(mesh, "weld_equal").changed, 0u);
  EXPECT_EQ(run_repair(mesh, "weld_close", 1e-4).changed, 16u);
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed);
  EXPECT_EQ(figures.vertices, 8u);
  EXPECT_EQ(mesh.position(Vertex(0)), loose.positions[0]);
}

TEST(repairs, a_flat_triangle_gives_its_corner_to_the_face_across) {
  // Vertex 3 lies on the side 0-1 of the triangle above; the flat triangle between closes the gap.
  IndexedMesh source = indexed({{0, 1, 2}, {1, 0, 3}, {0, 4, 3}, {3, 4, 1}});
  source.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}};
  Mesh mesh = from_indexed(source);
  const Figures before = compute_figures(mesh);
  EXPECT_EQ(before[ProblemKind::degenerate_area], 1u);
  const AlgorithmResult result = run_repair(mesh, "remove_degenerate");
  EXPECT_EQ(result.changed, 1u);
  EXPECT_EQ(result.text.en, "One face without area was removed: 1 corner given to the face across.");
  EXPECT_EQ(result.text.ja, "面積ゼロの面を 1 個なくしました（向かいの面への統合 1）。");
  const Figures after = compute_figures(mesh);
  EXPECT_EQ(after[ProblemKind::degenerate_area], 0u);
  EXPECT_EQ(after[ProblemKind::boundary_loop], before[ProblemKind::boundary_loop]) << "the surface stays closed there";
  EXPECT_DOUBLE_EQ(after.area, before.area);
}

TEST(repairs, a_face_of_many_corners_takes_all_corners_at_once) {
  // A convex face with a flat triangle at each side but the last; one by one it takes minutes.
  constexpr std::uint32_t n = 20000;
  Polygons faces(1);
  std::vector<glm::dvec3> places;
  for (std::uint32_t i = 0; i < n; ++i) {
    faces[0].push_back(i);
    places.push_back({2.0 * i, 2.0 * i * i, 0});
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    faces.push_back({i + 1, i, n + i});
    places.push_back((places[i] + places[i + 1]) / 2.0);
  }
  IndexedMesh source = indexed(faces);
  source.positions = places;
  Mesh mesh = from_indexed(source);
  EXPECT_EQ(run_repair(mesh, "remove_degenerate").changed, n - 1);
  const Figures after = compute_figures(mesh);
  EXPECT_EQ(after.faces, 1u);
  EXPECT_EQ(after.vertices, 2 * n - 1);
  EXPECT_EQ(after[ProblemKind::degenerate_area], 0u);
}

TEST(repairs, an_edge_without_length_collapses) {
  IndexedMesh source = indexed({{0, 1, 2}, {1, 3, 2}, {0, 4, 1}, {4, 3, 1}});
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}};
  Mesh mesh = from_indexed(source);
  EXPECT_EQ(run_repair(mesh, "remove_degenerate").changed, 2u);
  EXPECT_EQ(compute_figures(mesh).faces, 2u);
  EXPECT_EQ(compute_figures(mesh).boundary_loops, 1u);
}

// Points 0, 1, 2, and flat faces on 0-1 (the first half of them) and 1-2, each with a point of its own.
IndexedMesh with_pages(Polygons faces, std::uint32_t pages) {
  for (std::uint32_t i = 0; i < pages; ++i)
    faces.push_back(i < pages / 2 ? std::vector<std::uint32_t>{0, 1, i + 3} : std::vector<std::uint32_t>{1, 2, i + 3});
  IndexedMesh list = indexed(faces);
  list.positions[0] = {0, 0, 0};
  list.positions[1] = {1, 0, 0};
  list.positions[2] = {1, 1, 0};
  for (std::uint32_t i = 0; i < pages; ++i)
    list.positions[i + 3] = i < pages / 2 ? glm::dvec3(i + 2, 0, 0) : glm::dvec3(1, i + 2, 0);
  return list;
}

TEST(repairs, flat_pages_of_a_book_go_at_once) {
  Mesh mesh = from_indexed(with_pages({{0, 1, 2}}, 20000));  // one by one it takes minutes
  EXPECT_EQ(run_repair(mesh, "remove_degenerate").changed, 20000u);
  EXPECT_EQ(compute_figures(mesh).faces, 1u);
}

TEST(repairs, flat_pages_that_hold_a_pair_apart_stay_one_per_edge) {
  Mesh mesh = from_indexed(with_pages({{0, 1, 2}, {1, 0, 2}}, 6));
  const AlgorithmResult result = run_repair(mesh, "remove_degenerate");
  EXPECT_EQ(result.changed, 4u);
  EXPECT_EQ(result.left, 2u);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::hanging_pair], 0u);
}

TEST(repairs, duplicates_of_another_shape_stay) {
  IndexedMesh source = indexed({{0, 1, 2, 3}, {2, 3, 0, 1}, {0, 2, 1, 3}});
  Mesh mesh = from_indexed(source);
  const AlgorithmResult result = run_repair(mesh, "remove_duplicates");
  EXPECT_EQ(result.changed, 1u);
  EXPECT_EQ(result.left, 0u) << "the others come apart, since they run one edge alike";
  EXPECT_FALSE(mesh.is_alive(Face(1)));
  EXPECT_TRUE(mesh.is_alive(Face(0)) && mesh.is_alive(Face(2)));
}

// The reason is a clause about something that is not in it.
TEST(repairs, a_report_says_what_is_left_before_it_says_why) {
  const Mesh mesh = from_indexed(indexed({{0, 1, 2, 3}, {2, 1, 0, 3}, {0, 2, 1, 3}}));
  RepairReport report{1, {"One went.", "一枚"}, {}, {}};
  add_left(report.left, {"it turns the other way", "逆向きのため"}, {Face(2)});
  EXPECT_EQ(told(report, mesh).en, "One went. Left: one face (f2): it turns the other way.");
  EXPECT_EQ(told(report, mesh).ja, "一枚残り：面 1 枚（f2）：逆向きのため。");
  add_left(report.left, {"they are needed", "必要なため"}, {Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
  EXPECT_TRUE(
      told(report, mesh)
          .en.ends_with("Left: one face (f2): it turns the other way; 4 vertices (v0, v1, v2, ...): they are needed."))
      << told(report, mesh).en;
  report.left.clear();
  add_left(report.left, {"Boundary loop: this repair leaves it", "境界"}, {halfedge(Edge(0), 0), halfedge(Edge(1), 0)},
           true);
  EXPECT_TRUE(told(report, mesh).en.ends_with("Left: Boundary loop: this repair leaves it (2: 0-1, 0-2)."))
      << "a reason that names them needs no other subject: " << told(report, mesh).en;
}

TEST(repairs, a_hole_in_a_plane_is_filled_within_it) {
  IndexedMesh source;
  constexpr std::uint32_t n = 12;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) source.positions.push_back({i, j, 0});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      if (i > 2 && i < 9 && j > 2 && j < 9) continue;
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      for (std::uint32_t corner : {a, b, b + 1, a + 1}) source.corners.push_back(corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
  Mesh mesh = from_indexed(source);
  EXPECT_EQ(run_repair(mesh, "fill_holes", 30).changed, 1u) << "the outer border has 48 edges";
  const Figures figures = compute_figures(mesh);
  EXPECT_EQ(figures[ProblemKind::boundary_loop], 4u * n);
  EXPECT_NEAR(figures.area, n * n, 1e-9);
  EXPECT_EQ(figures[ProblemKind::degenerate_area], 0u);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) EXPECT_EQ(mesh.position(Vertex(i)).z, 0.0);
}

TEST(repairs, large_holes_are_filled_by_projection) {
  Mesh mesh = from_indexed(sphere_with_hole(200, 60));  // 400 edges
  EXPECT_EQ(run_repair(mesh, "fill_holes").changed, 1u);
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed && figures.manifold);
  EXPECT_EQ(figures[ProblemKind::degenerate_area], 0u);
}

TEST(repairs, borders_that_lie_on_each_other_are_left_to_welding) {
  // A sheet with a slit 0-1-2 of which both sides have a vertex of their own in the middle, at one place.
  IndexedMesh slit = indexed({{0, 1, 4}, {1, 2, 4}, {3, 0, 5}, {2, 3, 5}, {0, 4, 6}, {0, 6, 5}, {2, 7, 4}, {2, 5, 7}});
  slit.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {-2, 0, 0}, {2, 0, 0}};
  Mesh mesh = from_indexed(slit);
  ASSERT_EQ(compute_figures(mesh).boundary_loops, 2u);
  const AlgorithmResult result = run_repair(mesh, "fill_holes");
  EXPECT_EQ(result.changed, 0u);
  EXPECT_EQ(result.left, 2u) << "the outer border too, which only the sheet itself could close";
  EXPECT_EQ(run_repair(mesh, "weld_equal").changed, 1u);
  EXPECT_EQ(compute_figures(mesh).boundary_loops, 1u);
}

TEST(repairs, isolated_vertices_go) {
  Mesh mesh = make_mesh(two_quads(), 12);
  EXPECT_EQ(run_repair(mesh, "remove_isolated").changed, 6u);
  EXPECT_EQ(to_indexed(mesh).mesh.positions.size(), 6u);
}

TEST(repairs, filling_tells_how_far_it_is_within_a_hole) {
  IndexedMesh source = tube(40, 1, 1);  // both rims bent, each in its own way
  for (std::uint32_t i = 0; i < 80; ++i) source.positions[i].z += 0.1 * std::sin(M_PI * i / (i < 40 ? 10 : 5));
  Mesh mesh = from_indexed(std::move(source));
  std::vector<double> shares;
  Progress progress([&](double share) { return shares.push_back(share), true; }, {});
  Edit edit(mesh, nullptr);
  EXPECT_EQ(find_algorithm("fill_holes")->run(edit, {}, progress).changed, 2u);
  edit.commit();
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  const std::set<double> different(shares.begin(), shares.end());
  for (const double hole : {0.0, 0.5})
    EXPECT_GT(std::distance(different.upper_bound(hole), different.lower_bound(hole + 0.5)), 20) << hole;
}

}  // namespace
}  // namespace ryosen::test
