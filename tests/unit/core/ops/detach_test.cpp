#include "ryosen/ops/detach.h"

#include <gtest/gtest.h>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(detach, two_tetrahedra_on_an_edge_come_apart) {
  Mesh mesh = make_mesh(two_tetrahedra_on_an_edge());
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::nonmanifold_edge], 1u);
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{6, 11, 8, 0}));
  apply_and_prove(mesh, "detach f0");
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{8, 12, 8, 0}));
  const Figures after = compute_figures(mesh);
  EXPECT_TRUE(after.manifold && after.closed);
  EXPECT_EQ(after.components, 2u);
  EXPECT_EQ(rules_against(mesh, "collapse 0-1"), "duplicate_face") << "a tetrahedron alone, no copies";
}

TEST(detach, bow_tie_and_fin) {
  Mesh tie = make_mesh(bow_tie());
  apply_and_prove(tie, "detach f1");
  EXPECT_EQ(polygons_of(tie), (Polygons{{0, 1, 2}, {5, 3, 4}})) << "what stays keeps the number";
  Mesh fin_mesh = make_mesh(fin());
  apply_and_prove(fin_mesh, "detach f0");
  EXPECT_EQ(counts_on_points(fin_mesh).vertices, 7u);
  EXPECT_EQ(compute_figures(fin_mesh)[ProblemKind::nonmanifold_edge], 0u);
}

TEST(detach, a_face_inside_a_surface_alone) {
  Mesh mesh = make_mesh(torus_grid(4, 4));
  EXPECT_EQ(apply_and_prove(mesh, "detach f0"), (Change{.v = 3, .e = 3, .s = 1, .b = 2}));
  EXPECT_EQ(counts_on_points(mesh).vertices, 19u);
  const Vertex corner = mesh.from(mesh.halfedge(Face(0)));
  EXPECT_EQ(apply_and_prove(mesh, "weld 0 " + name_of(mesh, corner)), (Change{.v = -1, .s = -1, .b = -1}));
  EXPECT_EQ(counts_on_points(mesh).vertices, 18u);
}

TEST(detach, several_faces_as_a_patch) {
  Mesh mesh = make_mesh(torus_grid(4, 4));
  EXPECT_EQ(apply_and_prove(mesh, "detach f0 f1"), (Change{.v = 4, .e = 4, .s = 1, .b = 2}));
  EXPECT_EQ(rules_against(mesh, "detach f0"), "") << "one of the two, now that the patch touches nothing";
  EXPECT_EQ(rules_against(mesh, "detach f0 f1"), "detached");
}

TEST(detach, fans_of_one_vertex_and_wires) {
  Mesh mesh = make_mesh({{0, 1, 2}}, 6);
  apply_and_prove(mesh, "make_face 0 3 4");
  apply_and_prove(mesh, "make_edge 0 5 1-0");
  apply_and_prove(mesh, "detach f0");
  EXPECT_EQ(polygons_of(mesh), (Polygons{{6, 1, 2}, {0, 3, 4}}));
  EXPECT_TRUE(find_edge(mesh, "0-5").ok()) << "wires stay with the point";
  EXPECT_FALSE(has_copies(mesh, Vertex(0)));
}

TEST(detach, a_face_beside_a_bridge_and_values_at_corners) {
  Mesh mesh = mesh_of_exercise("cube_with_hole");
  EXPECT_EQ(apply_and_prove(mesh, "detach f0"), (Change{.v = 4, .e = 4, .s = 1, .b = 2}));
  EXPECT_EQ(compute_figures(mesh).rings, 2u);
}

TEST(detach, refused_where_nothing_is_touched) {
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}}), "detach f0"), "detached");
  EXPECT_EQ(rules_against(make_mesh(tetrahedron()), "detach f0 f1 f2 f3"), "detached");
  EXPECT_TRUE(Detach{}.check(make_mesh(tetrahedron())).has(Rule::deleted));
}

TEST(detach, parse_errors) {
  Mesh mesh = make_mesh(bow_tie());
  EXPECT_EQ(parse_error(mesh, "detach"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "detach v0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "detach f0 1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "detach f0 f9"), NameError::never_existed);
  apply_and_prove(mesh, "delete f0");
  EXPECT_EQ(parse_error(mesh, "detach f0"), NameError::deleted);
  EXPECT_TRUE((Detach{{Face(0)}}.check(mesh).has(Rule::deleted)));
}

}  // namespace
}  // namespace ryosen
