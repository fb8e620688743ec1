#include "ryosen/ops/make_face.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/copies.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(make_face, on_isolated_vertices) {
  Mesh mesh = make_mesh({}, 4);
  EXPECT_EQ(apply_and_prove(mesh, "make_face 0 1 2 3"), (Change{.e = 4, .f = 1, .s = -3, .b = -3}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 2, 3}}));
}

TEST(make_face, beside_a_face_and_around_a_corner) {
  Mesh mesh = make_mesh({{0, 1, 2}}, 5);
  EXPECT_EQ(apply_and_prove(mesh, "make_face 1 0 3"), (Change{.e = 2, .f = 1, .s = -1, .b = -1}));
  EXPECT_EQ(apply_and_prove(mesh, "make_face 3 0 2"), (Change{.e = 1, .f = 1})) << "one side new";
  EXPECT_EQ(apply_and_prove(mesh, "make_face 1 3 2"), (Change{.f = 1, .b = -1})) << "closes the tetrahedron";
  EXPECT_EQ(mesh.live(), (ElementCounts{5, 6, 4, 0}));
}

TEST(make_face, a_tetrahedron_from_points_by_faces_alone) {
  Mesh mesh = make_mesh({}, 4);
  for (const char* line : {"make_face 0 2 1", "make_face 0 1 3", "make_face 1 2 3", "make_face 0 3 2"})
    apply_and_prove(mesh, line);
  EXPECT_EQ(point_polygons(mesh), point_polygons(make_mesh(tetrahedron())));
  EXPECT_EQ(kernel_sum(mesh).boundaries, 0);
}

TEST(make_face, joins_two_fans_of_one_point) {
  Mesh mesh = make_mesh(bow_tie());
  ASSERT_TRUE(has_copies(mesh, Vertex(0)));
  apply_and_prove(mesh, "make_face 3 0 2");
  EXPECT_FALSE(has_copies(mesh, Vertex(0)));
  EXPECT_EQ(mesh.live(), (ElementCounts{5, 7, 3, 0}));
}

TEST(make_face, a_corner_alone_becomes_a_further_fan) {
  Mesh mesh = make_mesh({{0, 1, 2}}, 5);
  EXPECT_EQ(apply_and_prove(mesh, "make_face 0 3 4"), (Change{.e = 3, .f = 1, .s = -2, .b = -2}));
  EXPECT_FALSE(has_copies(mesh, Vertex(0))) << "one vertex with two fans, as after an Euler operator";
  EXPECT_EQ(rules_against(mesh, "separate_fans v0"), "");
}

TEST(make_face, several_fans_are_put_in_order) {
  Mesh mesh = make_mesh({}, 9);
  for (const char* line : {"make_face 0 1 2", "make_face 0 3 4", "make_face 0 5 6", "make_face 0 7 8"})
    apply_and_prove(mesh, line);
  for (const char* line : {"make_face 0 2 5", "make_face 0 6 3", "make_face 0 4 7", "make_face 0 8 1"})
    apply_and_prove(mesh, line);
  EXPECT_EQ(mesh.live(), (ElementCounts{9, 16, 8, 0}));
  EXPECT_FALSE(mesh.is_boundary(Vertex(0)));
}

TEST(make_face, takes_wires_as_sides) {
  Mesh mesh = make_mesh({}, 4);
  for (const char* line : {"make_edge 0 1", "make_edge 1 2", "make_edge 1 3 0-1"}) apply_and_prove(mesh, line);
  EXPECT_EQ(apply_and_prove(mesh, "make_face 2 1 0"), (Change{.e = 1, .f = 1}));
  EXPECT_EQ(mesh.live(), (ElementCounts{4, 4, 1, 0})) << "the third wire stays";
}

TEST(make_face, refusals) {
  const Mesh tetra = make_mesh(tetrahedron(), 6);
  EXPECT_EQ(rules_against(tetra, "make_face 0 0 1"), "corner_twice");
  EXPECT_EQ(rules_against(tetra, "make_face 0 4 5"), "no_gap");
  EXPECT_EQ(rules_against(tetra, "make_face 0 1 4"), "has_face");
  const Mesh fans = make_mesh({{0, 1, 2}, {1, 0, 3}}, 5);
  EXPECT_EQ(rules_against(fans, "make_face 1 2 0"), "has_face has_face has_face duplicate_face");
  EXPECT_EQ(rules_against(fans, "make_face 2 1 4"), "");
  EXPECT_EQ(rules_against(fans, "make_face 1 2 4"), "has_face") << "the wrong way round";
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}}), "make_face 2 1 0"), "duplicate_face");
  EXPECT_EQ(rules_against(make_mesh(fin(), 6), "make_face 1 0 5"), "has_face") << "three faces are there";
  EXPECT_TRUE((MakeFace{{Vertex(0), Vertex(1)}}.check(tetra).has(Rule::loop)));
  EXPECT_TRUE((MakeFace{{Vertex(0), Vertex(1), Vertex(99)}}.check(tetra).has(Rule::deleted)));
}

TEST(make_face, warns_of_a_flat_face) {
  IndexedMesh source = indexed({}, 3);
  source.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Mesh mesh = from_indexed(std::move(source));
  EXPECT_EQ(warnings(mesh, op_of(mesh, "make_face 0 1 2"))[0].rule, Rule::degenerate);
}

TEST(make_face, parse_errors) {
  Mesh mesh = make_mesh(closed_fan(3), 6);
  EXPECT_EQ(parse_error(mesh, "make_face"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "make_face 1 2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "make_face 1 2 f0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "make_face 1 2 9"), NameError::never_existed);
  apply_and_prove(mesh, "delete v1");
  EXPECT_EQ(parse_error(mesh, "make_face 1 4 5"), NameError::deleted);
}

}  // namespace
}  // namespace ryosen
