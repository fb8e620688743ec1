#include "ryosen/ops/delete.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(delete_op, face_of_a_closed_surface_leaves_its_edges_to_the_others) {
  Mesh mesh = make_mesh(cube());
  EXPECT_EQ(apply_and_prove(mesh, "delete f0"), (Change{.f = -1, .b = 1}));
  EXPECT_EQ(apply_and_prove(mesh, "make_face 0 2 3 1"), (Change{.f = 1, .b = -1}));
  EXPECT_EQ(mesh.live(), (ElementCounts{8, 12, 6, 0}));
}

TEST(delete_op, lone_triangle_goes_whole) {
  Mesh mesh = make_mesh({{0, 1, 2}}, 4);
  EXPECT_EQ(apply_and_prove(mesh, "delete f0"), (Change{.v = -3, .e = -3, .f = -1, .s = -1, .b = -1}));
  EXPECT_TRUE(mesh.is_alive(Vertex(3))) << "it was isolated before";
}

TEST(delete_op, vertex_takes_its_faces_and_leaves_a_hole) {
  Mesh mesh = make_mesh(torus_grid(5, 5));
  EXPECT_EQ(apply_and_prove(mesh, "delete v7"), (Change{.v = -1, .e = -6, .f = -6, .b = 1}));
  EXPECT_EQ(parse_error(mesh, "delete v7"), NameError::deleted);
}

TEST(delete_op, edge_takes_both_faces) {
  Mesh mesh = make_mesh(torus_grid(5, 5));
  EXPECT_EQ(apply_and_prove(mesh, "delete 0-1"), (Change{.e = -1, .f = -2, .b = 1}));
}

TEST(delete_op, vertex_may_keep_several_fans) {
  Mesh mesh = make_mesh(closed_fan(4));
  apply_and_prove(mesh, "delete f0");
  EXPECT_EQ(apply_and_prove(mesh, "delete f2"), (Change{.e = -1, .f = -1}));
  EXPECT_EQ(mesh.live().vertices, 5u) << "one vertex with two fans";
  EXPECT_EQ(apply_and_prove(mesh, "separate_fans v0"), (Change{.v = 1, .s = 1, .b = 1}));
}

TEST(delete_op, all_sheets_of_an_edge_and_all_copies_of_a_point) {
  Mesh edge_gone = make_mesh(fin());
  EXPECT_EQ(apply_and_prove(edge_gone, "delete 0-1").f, -3) << "named without a sheet";
  EXPECT_EQ(edge_gone.live(), (ElementCounts{0, 0, 0, 0}));
  Mesh point_gone = make_mesh(bow_tie());
  EXPECT_EQ(apply_and_prove(point_gone, "delete v0@f1").f, -2);
  EXPECT_EQ(point_gone.live(), (ElementCounts{0, 0, 0, 0}));
}

TEST(delete_op, the_last_two_sheets_of_an_edge_become_one_surface) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_TRUE(mesh.has_copies());
  apply_and_prove(mesh, "delete f2");
  EXPECT_EQ(mesh.live(), (ElementCounts{4, 5, 2, 0}));
  EXPECT_EQ(rules_against(mesh, "swap 0-1"), "");
}

TEST(delete_op, a_closed_sheet_comes_open_where_reading_would_open_it) {
  Mesh mesh = make_mesh(two_tetrahedra_on_an_edge());
  apply_and_prove(mesh, "delete f2");
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{6, 11, 7, 0}));
}

TEST(delete_op, a_copy_takes_over_the_number_of_its_point) {
  Mesh mesh = make_mesh(bow_tie());
  apply_and_prove(mesh, "delete f0");
  EXPECT_TRUE(mesh.is_alive(Vertex(0)));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 3, 4}}));
}

TEST(delete_op, wires_go_alone_or_with_their_vertex) {
  Mesh mesh = make_mesh({{0, 1, 2}}, 6);
  apply_and_prove(mesh, "make_edge 2 3");
  apply_and_prove(mesh, "make_edge 3 4");
  apply_and_prove(mesh, "make_edge 4 5");
  EXPECT_EQ(apply_and_prove(mesh, "delete 4-5"), (Change{.v = -1, .e = -1}));
  EXPECT_EQ(apply_and_prove(mesh, "delete f0"), (Change{.v = -2, .e = -3, .f = -1})) << "2 keeps its wire";
  EXPECT_EQ(apply_and_prove(mesh, "delete v3"), (Change{.v = -3, .e = -2, .s = -1, .b = -1}));
}

TEST(delete_op, a_face_takes_its_rings_and_bridges) {
  Mesh mesh = mesh_of_exercise("cube_with_hole");
  Face ringed;
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f)
    if (mesh.has_rings(Face(f))) ringed = Face(f);
  ASSERT_TRUE(ringed);
  EXPECT_EQ(apply_and_prove(mesh, "delete " + name_of(mesh, ringed)), (Change{.f = -1, .h = -1, .g = -1, .b = 2}));
  Mesh bridged = mesh_of_exercise("cube_with_hole");
  apply_and_prove(bridged, "unite_ring 0 8");
  const Face f = bridged.face(find_edge(bridged, "0-8").element);
  EXPECT_EQ(apply_and_prove(bridged, Delete{f}), (Change{.e = -1, .f = -1, .g = -1, .b = 2})) << "the bridge goes too";
}

TEST(delete_op, parse_errors) {
  Mesh mesh = make_mesh(tetrahedron());
  EXPECT_EQ(parse_error(mesh, "delete"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "delete x"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "delete f1 f2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "delete 0-1 2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "delete f9"), NameError::never_existed);
  EXPECT_EQ(parse_error(mesh, "delete 0-9"), NameError::never_existed);
  EXPECT_EQ(parse_error(mesh, "delete v9"), NameError::never_existed);
  apply_and_prove(mesh, "delete v3");
  EXPECT_EQ(parse_error(mesh, "delete v3"), NameError::deleted);
  EXPECT_EQ(parse_error(mesh, "delete f1"), NameError::deleted);
  EXPECT_TRUE((Delete{Face(1)}.check(mesh).has(Rule::deleted)));
  EXPECT_TRUE((Delete{Vertex(3)}.check(mesh).has(Rule::deleted)));
  EXPECT_TRUE((Delete{Edge()}.check(mesh).has(Rule::deleted)));
  EXPECT_TRUE(Delete::at(mesh, {}).check(mesh).has(Rule::deleted));
}

TEST(delete_op, a_click_takes_what_is_picked) {
  const Mesh mesh = make_mesh(tetrahedron());
  EXPECT_EQ(command_of(mesh, Delete::at(mesh, {Halfedge(), 0, Vertex(2), Face()})), "delete v2");
  EXPECT_EQ(command_of(mesh, Delete::at(mesh, {Halfedge(), 0, Vertex(), Face(1)})), "delete f1");
  EXPECT_EQ(command_of(mesh, Delete::at(mesh, {mesh.halfedge(Face(1)), 0.5, Vertex(), Face()})), "delete 0-1");
}

}  // namespace
}  // namespace ryosen
