#include "ryosen/ops/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/preview/remedy.h"
#include "ryosen/ops/rules/face_triangles.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Mesh placed(const Polygons& faces, std::vector<glm::dvec3> places) {
  IndexedMesh source = indexed(faces);
  source.positions = std::move(places);
  return from_indexed(std::move(source));
}

Mesh square_with_hole() {
  return placed({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}},
                {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 6, 0}});
}

TEST(triangulate_face, a_quad_is_cut_once_and_the_first_side_keeps_the_number) {
  Mesh mesh = placed({{0, 1, 2, 3}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_EQ(apply_and_prove(mesh, "triangulate f0"), (Change{.e = 1, .f = 1}));
  EXPECT_EQ(polygons_of(mesh)[0][0], 0u);
  EXPECT_EQ(polygons_of(mesh)[0][1], 1u);
}

TEST(triangulate_face, a_concave_face_is_cut_inside) {
  Mesh mesh = placed({{0, 1, 2, 3}}, {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
  const double area = compute_figures(mesh).area;
  apply_and_prove(mesh, "triangulate f0");
  EXPECT_TRUE(find_halfedge(mesh, Vertex(0), Vertex(2)));
  EXPECT_NEAR(compute_figures(mesh).area, area, 1e-12);
}

TEST(triangulate_face, all_faces_in_one_entry_of_the_history) {
  Mesh mesh = make_mesh(cube());
  EXPECT_EQ(apply_and_prove(mesh, "triangulate"), (Change{.e = 6, .f = 6}));
  EXPECT_EQ(rules_against(mesh, "triangulate"), "triangulated");
  EXPECT_EQ(rules_against(mesh, "triangulate f2"), "triangulated");
}

TEST(triangulate_face, a_ring_is_joined_by_the_triangles) {
  Mesh mesh = square_with_hole();
  apply_and_prove(mesh, "make_ring 0-4");
  const double area = compute_figures(mesh).area;
  const Change change = apply_and_prove(mesh, "triangulate f0");
  EXPECT_EQ(change.f, 7);
  EXPECT_EQ(change.e, 8);
  EXPECT_EQ(change.h, -1);
  EXPECT_EQ(mesh.live().faces, 8u) << "n + 2h - 2 with n = 8, h = 1";
  EXPECT_NEAR(compute_figures(mesh).area, area, 1e-12);
}

TEST(triangulate_face, a_bridge_stays_an_edge) {
  Mesh mesh = square_with_hole();
  const double area = compute_figures(mesh).area;
  EXPECT_EQ(apply_and_prove(mesh, "triangulate f0"), (Change{.e = 7, .f = 7}));
  EXPECT_NEAR(compute_figures(mesh).area, area, 1e-12);
  EXPECT_TRUE(find_halfedge(mesh, Vertex(0), Vertex(4)));
}

TEST(triangulate_face, takes_the_other_diagonal_where_one_is_an_edge) {
  for (const auto& [a, b] : {std::pair(0u, 2u), std::pair(1u, 3u)}) {
    Mesh mesh = make_mesh({{0, 1, 2, 3}, {a, b, 4}});
    apply_and_prove(mesh, "triangulate f0");
    EXPECT_TRUE(find_halfedge(mesh, Vertex(a == 0 ? 1 : 0), Vertex(a == 0 ? 3 : 2)));
  }
}

TEST(triangulate_face, searches_a_polygon_whose_drawn_triangles_are_taken) {
  Polygons faces{{0, 1, 2, 3, 4, 5}};
  std::vector<glm::dvec3> places;
  for (int i = 0; i < 6; ++i) places.push_back({std::cos(i), std::sin(i), 0});
  // Every diagonal but those of the corner 0 is an edge elsewhere.
  std::uint32_t next = 6;
  for (const auto& [a, b] : {std::pair(1u, 3u), {1u, 4u}, {1u, 5u}, {2u, 4u}, {2u, 5u}, {3u, 5u}}) {
    faces.push_back({a, b, next++});
    places.push_back({a, b, 5});
  }
  Mesh mesh = placed(faces, places);
  EXPECT_EQ(apply_and_prove(mesh, "triangulate f0"), (Change{.e = 3, .f = 3}));
  for (std::uint32_t v : {2u, 3u, 4u}) EXPECT_TRUE(find_halfedge(mesh, Vertex(0), Vertex(v)));
}

TEST(triangulate_face, is_refused_where_every_way_takes_an_edge_and_splitting_it_helps) {
  Mesh mesh = make_mesh({{0, 1, 2, 3}, {0, 2, 4}, {1, 3, 5}});
  EXPECT_EQ(rules_against(mesh, "triangulate f0"), "edge_exists");
  EXPECT_EQ(rules_against(mesh, "triangulate"), "edge_exists");
  const std::vector<std::string> remedy = find_remedy(mesh, Triangulate{Face(0)});
  ASSERT_FALSE(remedy.empty());
  for (const std::string& step : remedy) apply_and_prove(mesh, step);
  EXPECT_EQ(rules_against(mesh, "triangulate f0"), "");
}

TEST(triangulate_face, all_leaves_what_cannot_be_cut) {
  Mesh mesh = make_mesh({{0, 1, 2, 3}, {0, 2, 4}, {1, 3, 5}, {6, 7, 8, 9}});
  EXPECT_EQ(apply_and_prove(mesh, "triangulate"), (Change{.e = 1, .f = 1}));
  EXPECT_EQ(corner_count(mesh, Face(0)), 4u);
}

TEST(triangulate_face, one_of_two_faces_on_the_same_points_is_refused) {
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2, 3}, {0, 3, 2, 1}}), "triangulate f0"), "loses_duplicate");
}

TEST(triangulate_face, works_without_finite_places) {
  Mesh mesh = placed({{0, 1, 2, 3, 4}}, {{0, 0, 0}, {1, 0, 0}, {1, std::nan(""), 0}, {0, 1, 0}, {0, 0.5, 0}});
  EXPECT_EQ(apply_and_prove(mesh, "triangulate f0"), (Change{.e = 2, .f = 2}));
}

TEST(triangulate_face, dissolving_the_new_edges_takes_it_back) {
  Mesh mesh = make_mesh({{0, 1, 2, 3, 4}, {1, 0, 5}});
  const Polygons before = point_polygons(mesh);
  const std::uint32_t edges = mesh.edge_slots();
  apply_and_prove(mesh, "triangulate f0");
  for (std::uint32_t e = edges; e < edges + 2; ++e) apply_and_prove(mesh, "dissolve e" + std::to_string(e));
  EXPECT_EQ(point_polygons(mesh), before);
}

TEST(triangulate_face, lines_that_say_no_operator) {
  Mesh mesh = make_mesh(two_quads());
  EXPECT_EQ(parse_error(mesh, "triangulate f9"), NameError::never_existed);
  EXPECT_EQ(parse_error(mesh, "triangulate all"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "triangulate f0 f1"), NameError::malformed);
  apply_and_prove(mesh, "delete f1");
  EXPECT_EQ(parse_error(mesh, "triangulate f1"), NameError::deleted);
}

}  // namespace
}  // namespace ryosen
