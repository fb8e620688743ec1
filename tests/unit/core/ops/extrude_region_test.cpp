// Extrude of several faces at once.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/extrude.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// Squares of side 1 on a floor, row by row.
Mesh floor_of_squares(std::uint32_t columns, std::uint32_t rows) {
  Polygons faces;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t v = y * (columns + 1) + x;
      faces.push_back({v, v + 1, v + columns + 2, v + columns + 1});
    }
  IndexedMesh source = indexed(faces);
  for (std::uint32_t i = 0; i < source.positions.size(); ++i)
    source.positions[i] = {i % (columns + 1), i / (columns + 1), 0};
  return from_indexed(std::move(source));
}

Mesh unit_cube() {
  IndexedMesh source = indexed(cube());
  for (std::size_t i = 0; i < 8; ++i) source.positions[i] = {i & 1, (i >> 1) & 1, i >> 2};
  return from_indexed(std::move(source));
}

// The names of faces of the cube that share a corner, ascending.
std::string faces_at(const Mesh& mesh, Vertex v) {
  std::set<Face> faces;
  for (Face f : faces_around(mesh, v)) faces.insert(f);
  std::string names;
  for (Face f : faces) names += " " + name_of(mesh, f);
  return names;
}

TEST(extrude_region, two_squares_move_as_one) {
  Mesh mesh = floor_of_squares(2, 1);
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0 f1"), (Change{.v = 6, .e = 12, .f = 6}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{6, 9, 7, 8},
                                         {9, 10, 11, 7},
                                         {0, 1, 9, 6},
                                         {4, 3, 8, 7},
                                         {3, 0, 6, 8},
                                         {1, 2, 10, 9},
                                         {2, 5, 11, 10},
                                         {5, 4, 7, 11}}));
  EXPECT_EQ(mesh.position(Vertex(6)), glm::dvec3(0, 0, 1)) << "by the square root of the mean area";
}

TEST(extrude_region, a_face_that_is_named_twice_counts_once) {
  Mesh once = floor_of_squares(2, 2), twice = floor_of_squares(2, 2);
  apply_and_prove(once, "extrude f0 f3 2");
  apply_and_prove(twice, "extrude f0 f3 f0 2");
  EXPECT_EQ(once.hash(), twice.hash());
}

TEST(extrude_region, neighbours_on_a_cube_keep_it_closed) {
  Mesh mesh = unit_cube();
  const std::string names = faces_at(mesh, Vertex(0));
  EXPECT_EQ(apply_and_prove(mesh, "extrude" + names + " 1"), (Change{.v = 6, .e = 12, .f = 6}))
      << "the corner that they share moves";
  EXPECT_EQ(glm::length(mesh.position(Vertex(0))), 1);
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed && figures.manifold);
}

TEST(extrude_region, opposite_faces_of_a_cube_have_walls_of_their_own) {
  Mesh mesh = unit_cube();
  const std::string first = " f0";
  std::string opposite;
  for (std::uint32_t f = 1; f < 6; ++f) {
    std::set<Vertex> corners;
    for (Vertex v : vertices_around(mesh, Face(0))) corners.insert(v);
    for (Vertex v : vertices_around(mesh, Face(f))) corners.insert(v);
    if (corners.size() == 8) opposite = " " + name_of(mesh, Face(f));
  }
  EXPECT_EQ(apply_and_prove(mesh, "extrude" + first + opposite + " 0,0,3"), (Change{.v = 8, .e = 16, .f = 8}));
}

TEST(extrude_region, all_but_one_face_of_a_cube_lift_it_off_that_one) {
  Mesh mesh = unit_cube();
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0 f1 f2 f3 f4 1"), (Change{.v = 4, .e = 8, .f = 4}));
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed && figures.manifold);
}

TEST(extrude_region, a_closed_surface_moves_only_where_it_is_told_to) {
  Mesh mesh = unit_cube();
  const Polygons before = polygons_of(mesh);
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0 f1 f2 f3 f4 f5"), Change{});
  EXPECT_EQ(mesh.position(Vertex(7)), glm::dvec3(1, 1, 1)) << "it has no normal";
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0 f1 f2 f3 f4 f5 1,2,3"), Change{});
  EXPECT_EQ(mesh.position(Vertex(7)), glm::dvec3(2, 3, 4));
  EXPECT_EQ(polygons_of(mesh), before);
}

TEST(extrude_region, the_points_within_a_block_move_without_a_wall) {
  Mesh mesh = floor_of_squares(4, 4);
  const double area = compute_figures(mesh).area;
  EXPECT_EQ(apply_and_prove(mesh, "extrude f0 f1 f4 f5 1"), (Change{.v = 8, .e = 16, .f = 8}));
  EXPECT_EQ(mesh.position(Vertex(6)), glm::dvec3(1, 1, 1));
  EXPECT_EQ(compute_figures(mesh).area - area, 8) << "at the boundary of the mesh too";
}

TEST(extrude_region, a_ring_of_faces_has_walls_outside_and_inside) {
  Mesh mesh = floor_of_squares(5, 5);
  EXPECT_EQ(apply_and_prove(mesh, "extrude f6 f7 f8 f11 f13 f16 f17 f18 1"), (Change{.v = 16, .e = 32, .f = 16}));
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.manifold);
  EXPECT_EQ(figures[ProblemKind::boundary_loop], 20u) << "only that around the floor";
  EXPECT_EQ(figures.area, 25 + 16);
}

TEST(extrude_region, faces_that_touch_at_a_point_share_the_new_one) {
  Mesh mesh = floor_of_squares(2, 2);
  apply_and_prove(mesh, "extrude f0 f3 1");
  EXPECT_EQ(mesh.live().faces, 12u);
  EXPECT_EQ(counts_on_points(mesh).vertices, 9u + 7u);
  EXPECT_EQ(counts_on_points(mesh).edges, 12u + 8u + 7u);
  EXPECT_EQ(differs_from_reading(mesh), "");
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::nonmanifold_edge], 1u) << "four walls stand on the middle";
}

TEST(extrude_region, one_page_of_a_book_leaves_the_others) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  apply_and_prove(mesh, "extrude f1 0,0,1");
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::nonmanifold_edge], 1u);
  EXPECT_EQ(mesh.live().faces, 6u);
}

TEST(extrude_region, two_pages_of_a_book_have_one_wall_in_common) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  apply_and_prove(mesh, "extrude f0 f1 0,0,1");
  EXPECT_EQ(mesh.live().faces, 3u + 5u) << "of 0-1 and of four other sides";
  EXPECT_EQ(counts_on_points(mesh).vertices, 5u + 4u);
  const Figures figures = compute_figures(mesh);
  EXPECT_EQ(figures[ProblemKind::nonmanifold_edge], 3u)
      << "above: both pages and their wall; and up to there: three walls";
  EXPECT_EQ(figures[ProblemKind::misoriented_edge], 1u) << "below: the wall follows the side of the first page";
}

TEST(extrude_region, all_pages_of_a_book_move_with_its_back) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  apply_and_prove(mesh, "extrude f0 f1 f2 0,0,1");
  EXPECT_EQ(mesh.live().faces, 3u + 6u);
  EXPECT_EQ(counts_on_points(mesh).vertices, 5u + 5u);
}

TEST(extrude_region, neighbours_that_disagree_in_direction_get_no_wall_between_them) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 1, 3}});
  apply_and_prove(mesh, "extrude f0 f1 0,0,1");
  EXPECT_EQ(mesh.live().faces, 2u + 4u);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::misoriented_edge], 3u) << "above, as it was below, and up to there";
}

TEST(extrude_region, a_wire_and_a_cone_at_its_tip_stay_below) {
  Mesh wired = floor_of_squares(1, 1);
  apply_and_prove(wired, "make_vertex 0,0,5");
  apply_and_prove(wired, "make_edge v0 v4");
  apply_and_prove(wired, "extrude f0 1");
  EXPECT_EQ(wired.position(Vertex(0)), glm::dvec3(0));
  EXPECT_TRUE(find_halfedge(wired, Vertex(0), Vertex(4)));
  // Two tetrahedra with a point in common: the one that moves takes a copy of it along, without walls.
  Mesh mesh = make_mesh({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {3, 4, 5}, {3, 5, 6}, {3, 6, 4}, {4, 6, 5}});
  apply_and_prove(mesh, "extrude f0 f1 f2 f3 0,0,1");
  EXPECT_EQ(mesh.live().faces, 8u);
  EXPECT_FALSE(mesh.has_copies() && has_copies(mesh, Vertex(3)));
  EXPECT_EQ(counts_on_points(mesh).vertices, 8u);
}

TEST(extrude_region, duplicates_move_together_or_not_at_all) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 1}, {2, 1, 3}});
  EXPECT_EQ(rules_against(mesh, "extrude f1 f2 1"), "loses_duplicate");
  EXPECT_EQ(rules_against(mesh, "extrude f0 f1 0,0,1"), "");
  apply_and_prove(mesh, "extrude f0 f1 0,0,1");
  EXPECT_EQ(mesh.live().faces, 4u);
}

TEST(extrude_region, welding_what_was_replaced_takes_it_back) {
  Mesh mesh = floor_of_squares(3, 3);
  const auto before = point_polygons(mesh);
  apply_and_prove(mesh, "extrude f4 f5 1");
  for (int wall = 9; wall < 15; ++wall) apply_and_prove(mesh, "delete f" + std::to_string(wall));
  apply_and_prove(mesh, "extrude f4 f5 0,0,-1");  // as an island it gets walls again
  EXPECT_EQ(mesh.live().faces, 9u + 6u);
  mesh = floor_of_squares(3, 3);
  apply_and_prove(mesh, "extrude f4 f5 1");
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (int wall = 9; wall < 15; ++wall) {
    const Halfedge side = mesh.halfedge(Face(static_cast<std::uint32_t>(wall)));
    pairs.emplace_back(mesh.from(mesh.prev(side)), mesh.from(side));
  }
  for (int wall = 9; wall < 15; ++wall) apply_and_prove(mesh, "delete f" + std::to_string(wall));
  for (const auto& [top, bottom] : pairs)
    apply_and_prove(mesh, "weld " + name_of(mesh, top) + " " + name_of(mesh, bottom));
  EXPECT_EQ(point_polygons(mesh), before);
}

TEST(extrude_region, lines_with_several_faces) {
  const Mesh mesh = floor_of_squares(2, 1);
  EXPECT_EQ(command_of(mesh, op_of(mesh, "extrude f1 f0 0.5")), "extrude f1 f0 0.5");
  EXPECT_EQ(parse_error(mesh, "extrude f0 f7 1"), NameError::never_existed);
  EXPECT_EQ(parse_error(mesh, "extrude f0 1 f1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude 1"), NameError::malformed);
  EXPECT_FALSE(check(mesh, AnyOp(Extrude{})).legal());
}

}  // namespace
}  // namespace ryosen
