#include "ryosen/ops/weld.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// Two triangles beside each other with a slit between 1-2 and 4-5, closed at the point 1 = 4 if `joined`.
Polygons slit(bool joined) {
  if (joined) return {{0, 1, 2}, {1, 3, 5}};
  return {{0, 1, 2}, {4, 3, 5}};
}

TEST(weld, two_loose_vertices_and_a_loose_one_with_a_face) {
  Mesh mesh = make_mesh({{0, 1, 2}}, 5);
  EXPECT_EQ(apply_and_prove(mesh, "weld 3 4"), (Change{.v = -1, .s = -1, .b = -1}));
  const glm::dvec3 place = mesh.position(Vertex(3));
  EXPECT_EQ(apply_and_prove(mesh, "weld 3 0"), (Change{.v = -1, .s = -1, .b = -1}));
  EXPECT_EQ(mesh.position(Vertex(0)), place) << "the lower number stays, at the place of the first";
  EXPECT_FALSE(mesh.is_alive(Vertex(3)));
}

TEST(weld, across_a_gap_of_two_edges) {
  Mesh mesh = make_mesh(slit(true));
  EXPECT_EQ(rules_against(mesh, "weld 2 5"), "");
  apply_and_prove(mesh, "weld 2 5");
  EXPECT_EQ(point_polygons(mesh), (Polygons{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(mesh.live(), (ElementCounts{5, 5, 2, 0})) << "one edge 1-2 with two faces, no copies";
  EXPECT_EQ(rules_against(mesh, "swap 1-2"), "");
}

TEST(weld, two_boundary_edges) {
  for (const char* line : {"weld 1-2 4-5", "weld 2-1 5-4", "weld 2-1 4-5"}) {
    Mesh mesh = make_mesh(slit(false));
    EXPECT_EQ(apply_and_prove(mesh, line), (Change{.v = -2, .e = -1, .s = -1, .b = -1})) << line;
    EXPECT_EQ(point_polygons(mesh), (Polygons{{0, 1, 2}, {1, 3, 2}})) << line;
  }
  Mesh far = make_mesh(slit(false));
  const glm::dvec3 place = far.position(Vertex(4));
  apply_and_prove(far, "weld 4-5 1-2");
  EXPECT_EQ(far.position(Vertex(1)), place) << "the place is that of the first edge";
}

TEST(weld, in_the_middle_or_anywhere) {
  Mesh edges = make_mesh(slit(false));
  const glm::dvec3 one = edges.position(Vertex(1)), two = edges.position(Vertex(2)), four = edges.position(Vertex(4)),
                   five = edges.position(Vertex(5));
  EXPECT_EQ(apply_and_prove(edges, "weld 1-2 4-5 mid"), (Change{.v = -2, .e = -1, .s = -1, .b = -1}));
  EXPECT_LT(glm::distance(edges.position(Vertex(1)), (one + four) / 2.0), 1e-12);
  EXPECT_LT(glm::distance(edges.position(Vertex(2)), (two + five) / 2.0), 1e-12);
  Mesh slit_at_one = make_mesh(slit(true));
  apply_and_prove(slit_at_one, "weld 2 5 7,8,9");
  EXPECT_EQ(slit_at_one.position(Vertex(2)), glm::dvec3(7, 8, 9));
  Mesh fans = make_mesh(bow_tie());
  const glm::dvec3 place = fans.position(Vertex(0));
  apply_and_prove(fans, "weld v0@f0 v0@f1 mid");
  EXPECT_EQ(fans.position(Vertex(0)), place) << "one point has one place";
}

TEST(weld, edges_with_a_common_end_close_the_gap) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
  EXPECT_EQ(apply_and_prove(mesh, "weld 0-1 0-5"), (Change{.v = -1, .e = -1}));
  EXPECT_EQ(point_polygons(mesh), point_polygons(make_mesh(closed_fan(4))));
}

TEST(weld, the_ends_of_a_strip_become_a_band) {
  Mesh mesh = make_mesh({{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {6, 7, 9, 8}});
  EXPECT_EQ(apply_and_prove(mesh, "weld 0-1 8-9"), (Change{.v = -2, .e = -1, .b = 1}));
  EXPECT_EQ(compute_figures(mesh).boundary_loops, 2u);
  EXPECT_TRUE(compute_figures(mesh).orientable);
}

TEST(weld, unrelated_surfaces_meet_in_one_point) {
  Mesh mesh = make_mesh({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {4, 7, 6}});
  EXPECT_EQ(apply_and_prove(mesh, "weld 0 4"), Change()) << "closed fans stay copies of the one point";
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{7, 12, 8, 0}));
  EXPECT_EQ(compute_figures(mesh).bowtie_vertices, 1u);
  apply_and_prove(mesh, "detach f4");
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{8, 12, 8, 0}));
}

TEST(weld, copies_become_one_vertex) {
  Mesh mesh = make_mesh(bow_tie());
  const Figures before = compute_figures(mesh);
  EXPECT_EQ(apply_and_prove(mesh, "weld v0@f0 v0@f1"), (Change{.v = -1, .s = -1, .b = -1}));
  EXPECT_EQ(compute_figures(mesh), before);
  EXPECT_EQ(apply_and_prove(mesh, "separate_fans v0"), (Change{.v = 1, .s = 1, .b = 1}));
  EXPECT_EQ(compute_figures(mesh), before);
}

TEST(weld, the_colour_of_the_first_stays) {
  IndexedMesh source = indexed(slit(false));
  for (double red : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) source.vertex_colours.push_back({red, 0, 0, 1});
  Mesh mesh = from_indexed(std::move(source));
  const AttributeColumn before = mesh.attributes()[0];
  apply_and_prove(mesh, "weld 4-5 1-2");
  const AttributeColumn& after = mesh.attributes()[0];
  for (std::uint32_t word = 0; word < before.words(); ++word) {
    EXPECT_EQ(after.data[1 * before.words() + word], before.data[4 * before.words() + word]);
    EXPECT_EQ(after.data[2 * before.words() + word], before.data[5 * before.words() + word]);
  }
}

TEST(weld, refusals) {
  const Mesh tetra = make_mesh(tetrahedron());
  EXPECT_EQ(rules_against(tetra, "weld 0 0"), "same_vertex");
  EXPECT_TRUE(check(tetra, op_of(tetra, "weld 0 1")).has(Rule::common_face));
  EXPECT_EQ(rules_against(tetra, "weld 0-1 1-0"), "same_edge");
  EXPECT_EQ(rules_against(tetra, "weld 0-1 2-3"), "has_face has_face");
  Mesh wires = make_mesh({}, 4);
  for (const char* line : {"make_edge 0 1", "make_edge 2 1", "make_edge 2 3"}) apply_and_prove(wires, line);
  EXPECT_EQ(rules_against(wires, "weld 0 2"), "common_neighbour") << "two wires would fall together";
  EXPECT_EQ(rules_against(wires, "weld 0 1"), "edge_exists");
  EXPECT_EQ(rules_against(wires, "weld 0-1 2-3"), "wire wire");
  const Mesh quads = make_mesh({{0, 1, 2}, {2, 1, 3}});
  EXPECT_EQ(rules_against(quads, "weld 0 3"), "duplicate_face") << "a hanging pair";
  const Mesh inside = make_mesh(torus_grid(4, 4));
  EXPECT_TRUE(check(inside, op_of(inside, "weld 0 2")).has(Rule::common_neighbour));
  const Mesh two = make_mesh({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {0, 6, 5}});
  EXPECT_EQ(rules_against(two, "weld v0@f0 v0@f4"), "no_gap no_gap");
  const Mesh fan = make_mesh({{0, 1, 2}, {0, 3, 4}, {1, 0, 4}});
  EXPECT_TRUE(check(fan, op_of(fan, "weld 1-2 2-0")).has(Rule::common_face)) << "two sides of one face";
}

TEST(weld, against_the_direction_of_the_faces_is_refused) {
  const Mesh mesh = make_mesh({{0, 1, 2}, {0, 3, 4}}, 5);
  EXPECT_TRUE(check(mesh, op_of(mesh, "weld 0-1 0-3")).has(Rule::common_face)) << "both faces would run it one way";
  EXPECT_EQ(rules_against(mesh, "weld 0-1 0-4"), "");
}

TEST(weld, parse_errors) {
  Mesh mesh = make_mesh(slit(false));
  EXPECT_EQ(parse_error(mesh, "weld"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "weld 1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "weld 1 2-0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "weld 1-2 4-5 3"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "weld 1-2 4-5 0,0,0"), NameError::malformed) << "two places would be needed";
  EXPECT_EQ(parse_error(mesh, "weld 1 4 middle"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "weld 1-2 4-9"), NameError::never_existed);
  apply_and_prove(mesh, "delete v4");
  EXPECT_EQ(parse_error(mesh, "weld 1 4"), NameError::deleted);
  EXPECT_TRUE((Weld{Vertex(1), Vertex(4), Halfedge(), Halfedge()}.check(mesh).has(Rule::deleted)));
  EXPECT_TRUE(Weld{}.check(mesh).has(Rule::deleted));
}

}  // namespace
}  // namespace ryosen
