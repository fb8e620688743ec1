#include "ryosen/ops/extrude.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Mesh unit_square() {
  IndexedMesh source = indexed({{0, 1, 2, 3}});
  source.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  return from_indexed(std::move(source));
}

Mesh bridged_square() {
  IndexedMesh source = indexed({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  source.positions = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 6, 0}};
  return from_indexed(std::move(source));
}

TEST(extrude, a_square_becomes_an_open_box_as_high_as_wide) {
  Mesh mesh = unit_square();
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0"), (Change{.v = 4, .e = 8, .f = 4}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}));
  EXPECT_EQ(mesh.position(Vertex(4)), glm::dvec3(0, 0, 2));
  EXPECT_EQ(mesh.position(Vertex(6)), glm::dvec3(2, 2, 2));
}

TEST(extrude, by_a_distance_and_by_a_vector) {
  Mesh down = unit_square();
  apply_and_prove(down, "extrude f0 -0.5");
  EXPECT_EQ(down.position(Vertex(5)), glm::dvec3(2, 0, -0.5));
  Mesh aside = unit_square();
  apply_and_prove(aside, "extrude f0 1,2,3");
  EXPECT_EQ(aside.position(Vertex(5)), glm::dvec3(3, 2, 3));
}

TEST(extrude, a_face_of_a_cube_keeps_it_closed_and_outward) {
  IndexedMesh source = indexed(cube());
  for (std::size_t i = 0; i < 8; ++i) source.positions[i] = {i & 1, (i >> 1) & 1, i >> 2};
  Mesh mesh = from_indexed(std::move(source));
  const double volume = compute_figures(mesh).volume.value();
  EXPECT_EQ(apply_and_prove(mesh, "extrude f1 2"), (Change{.v = 4, .e = 8, .f = 4}));
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed && figures.manifold);
  EXPECT_NEAR(figures.volume.value() - volume, volume > 0 ? 2 : -2, 1e-12);
}

TEST(extrude, rings_get_their_walls) {
  Mesh mesh = bridged_square();
  apply_and_prove(mesh, "make_ring 0-4");
  const double area = compute_figures(mesh).area;
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0 1"), (Change{.v = 8, .e = 16, .f = 8}));
  EXPECT_NEAR(compute_figures(mesh).area - area, 4 * 9 + 4 * 3, 1e-12);
  EXPECT_TRUE(mesh.has_rings(Face(0)));
}

TEST(extrude, a_bridge_goes_along_without_a_wall) {
  Mesh mesh = bridged_square();
  ASSERT_FALSE(mesh.has_rings());
  const double area = compute_figures(mesh).area;
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0 1"), (Change{.v = 8, .e = 16, .f = 8}));
  EXPECT_NEAR(compute_figures(mesh).area - area, 4 * 9 + 4 * 3, 1e-12);
  EXPECT_EQ(find_halfedge(mesh, Vertex(0), Vertex(4)), Halfedge());
}

TEST(extrude, edges_that_are_cut_keep_their_faces) {
  for (const Polygons& faces : {fin(), bow_tie(), moebius_strip(), two_tetrahedra_on_an_edge()}) {
    Mesh mesh = make_mesh(faces);
    const Figures before = compute_figures(mesh);
    EXPECT_EQ(apply_and_prove(mesh, "extrude f0 0.1"), (Change{.v = 3, .e = 6, .f = 3}));
    const Figures after = compute_figures(mesh);
    EXPECT_EQ(after[ProblemKind::nonmanifold_edge], before[ProblemKind::nonmanifold_edge]);
    EXPECT_EQ(after[ProblemKind::misoriented_edge], before[ProblemKind::misoriented_edge]);
    EXPECT_EQ(after[ProblemKind::boundary_loop], before[ProblemKind::boundary_loop]);
  }
}

TEST(extrude, without_its_walls_and_back_in_its_place_the_mesh_is_the_same) {
  Mesh mesh = make_mesh(cube());
  const Polygons before = point_polygons(mesh);
  std::string line = "make_face";
  for (Vertex v : vertices_around(mesh, Face(1))) line += " " + name_of(mesh, v);
  apply_and_prove(mesh, "extrude f1 3");
  for (const char* wall : {"f6", "f7", "f8", "f9", "f1"}) apply_and_prove(mesh, std::string("delete ") + wall);
  apply_and_prove(mesh, line);
  EXPECT_EQ(point_polygons(mesh), before);
}

TEST(extrude, one_of_two_faces_on_the_same_points_is_refused) {
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}, {0, 2, 1}}), "extrude f1"), "loses_duplicate");
}

TEST(extrude, stays_finite_and_warns_of_flat_walls) {
  IndexedMesh source = indexed({{0, 1, 2}});
  source.positions = {{1e308, 0, 0}, {1.5e308, 0, 0}, {1e308, 1e300, 0}};
  const Mesh far = from_indexed(std::move(source));
  EXPECT_EQ(parse_error(far, "extrude f0 1e308,0,0"), NameError::malformed);
  const Mesh square = unit_square();
  EXPECT_EQ(warnings(square, op_of(square, "extrude f0 0"))[0].rule, Rule::degenerate);
  EXPECT_TRUE(warnings(square, op_of(square, "extrude f0")).empty());
  IndexedMesh flat = indexed({{0, 1, 2}});
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, std::nan(""), 0}};
  const Mesh unmeasured = from_indexed(std::move(flat));
  EXPECT_EQ(Extrude{{Face(0)}}.movement(unmeasured), glm::dvec3());
}

TEST(extrude, lines_that_say_no_operator) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(parse_error(mesh, "extrude"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude f0 up"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude f0 1,2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude f0 1 2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude f7"), NameError::never_existed);
  apply_and_prove(mesh, "delete f0");
  EXPECT_EQ(parse_error(mesh, "extrude f0"), NameError::deleted);
}

}  // namespace
}  // namespace ryosen
