#include "ryosen/ops/fill.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/copies.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(fill, puts_a_face_on_a_hole_and_delete_takes_it_away) {
  Mesh mesh = make_mesh(cube());
  apply_and_prove(mesh, "delete f3");
  const MeshColumns open = mesh.columns();
  EXPECT_EQ(apply_and_prove(mesh, "fill 2-6"), (Change{.f = 1, .b = -1}));
  EXPECT_EQ(polygons_of(mesh).back(), (std::vector<std::uint32_t>{2, 6, 7, 3}));
  apply_and_prove(mesh, "delete f6");
  EXPECT_EQ(mesh.live(), Mesh(open).live());
}

TEST(fill, takes_a_boundary_edge_by_either_of_its_names) {
  Mesh one = make_mesh(closed_fan(5)), other = make_mesh(closed_fan(5));
  apply_and_prove(one, "fill 1-2");
  apply_and_prove(other, "fill 2-1");
  EXPECT_EQ(point_polygons(one), point_polygons(other));
  EXPECT_EQ(one.live().faces, 6u);
  EXPECT_EQ(rules_against(one, "fill 1-2"), "has_face");
}

TEST(fill, wires_become_sides) {
  Mesh mesh = make_mesh({}, 3);
  for (const char* line : {"make_edge 0 1", "make_edge 1 2", "make_edge 2 0"}) apply_and_prove(mesh, line);
  EXPECT_EQ(apply_and_prove(mesh, "fill 0-1"), (Change{.f = 1, .b = -1}));
  EXPECT_EQ(rules_against(mesh, "fill 1-0"), "duplicate_face") << "the other side of the only face";
}

TEST(fill, refuses_a_face_a_repeated_point_a_short_cycle_and_a_duplicate) {
  EXPECT_EQ(rules_against(make_mesh(tetrahedron()), "fill 0-1"), "has_face");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}}), "fill 0-1"), "duplicate_face");
  Mesh wire = make_mesh({}, 2);
  apply_and_prove(wire, "make_edge 0 1");
  EXPECT_EQ(rules_against(wire, "fill 0-1"), "loop");
  Mesh fans = make_mesh(closed_fan(4));
  apply_and_prove(fans, "delete f0");
  apply_and_prove(fans, "delete f2");
  EXPECT_EQ(rules_against(fans, "fill 0-1"), "corner_twice");
  Mesh dangling = make_mesh({{0, 1, 2, 3}}, 5);
  apply_and_prove(dangling, "make_edge 0 4");
  EXPECT_EQ(rules_against(dangling, "fill 0-1"), "corner_twice");
}

TEST(fill, leaves_an_edge_with_faces_enough_alone) {
  const Mesh mesh = make_mesh(fin());
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
    if (mesh.is_outside(Halfedge(i)) && point_edge(mesh, Halfedge(i)).is_nonmanifold()) {
      EXPECT_TRUE(Fill{Halfedge(i)}.check(mesh).has(Rule::copies));
    }
}

TEST(fill, warns_of_a_flat_face) {
  IndexedMesh source = indexed({{0, 1, 3}, {1, 2, 3}, {2, 4, 3}, {4, 0, 3}});
  source.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 1}, {3, 0, 0}};
  const Mesh mesh = from_indexed(std::move(source));
  const AnyOp op = op_of(mesh, "fill 0-1");
  ASSERT_TRUE(check(mesh, op).legal());
  EXPECT_EQ(warnings(mesh, op)[0].rule, Rule::degenerate);
}

TEST(fill, parse_errors) {
  Mesh mesh = make_mesh(closed_fan(4));
  EXPECT_EQ(parse_error(mesh, "fill"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "fill 12"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "fill 1-2 3"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "fill 1-3"), NameError::never_existed);
  apply_and_prove(mesh, "delete v1");
  EXPECT_EQ(parse_error(mesh, "fill 1-2"), NameError::deleted);
  EXPECT_TRUE((Fill{Halfedge()}.check(mesh).has(Rule::deleted)));
}

}  // namespace
}  // namespace ryosen
