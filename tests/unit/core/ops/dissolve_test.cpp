#include "ryosen/ops/dissolve.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/preview/remedy.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(dissolve_edge, two_faces_become_one_and_the_lower_number_stays) {
  Mesh mesh = make_mesh(two_quads());
  EXPECT_EQ(apply_and_prove(mesh, "dissolve 0-1"), (Change{.e = -1, .f = -1}));
  EXPECT_EQ(point_polygons(mesh), (Polygons{{0, 4, 5, 1, 2, 3}}));
  EXPECT_TRUE(mesh.is_alive(Face(0)));
}

TEST(dissolve_edge, a_shared_chain_goes_as_one) {
  const Polygons faces{{0, 1, 2, 3, 4}, {2, 1, 0, 5}};
  for (const char* line : {"dissolve 0-1", "dissolve 1-2", "dissolve 2-1"}) {
    Mesh mesh = make_mesh(faces);
    EXPECT_EQ(apply_and_prove(mesh, line), (Change{.v = -1, .e = -2, .f = -1}));
    EXPECT_EQ(point_polygons(mesh), (Polygons{{0, 5, 2, 3, 4}}));
  }
}

TEST(dissolve_edge, is_the_inverse_of_dividing) {
  Mesh mesh = make_mesh(cube());
  const Polygons before = point_polygons(mesh);
  const std::string a = std::to_string(mesh.from(mesh.halfedge(Face(2))).index),
                    c = std::to_string(mesh.to(mesh.next(mesh.halfedge(Face(2)))).index);
  apply_and_prove(mesh, "separate_loop " + a + " " + c);
  apply_and_prove(mesh, "dissolve " + a + "-" + c);
  EXPECT_EQ(point_polygons(mesh), before);
}

TEST(dissolve_edge, keeps_the_rings_of_both) {
  IndexedMesh source = indexed({{0, 1, 2, 3, 0, 6, 8, 7, 6}, {1, 0, 4, 5}});
  source.positions = {{0, 0, 0},  {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, -9, 0},
                      {9, -9, 0}, {3, 3, 0}, {6, 3, 0}, {3, 6, 0}};
  Mesh mesh = from_indexed(std::move(source));
  apply_and_prove(mesh, "make_ring 0-6");
  EXPECT_EQ(apply_and_prove(mesh, "dissolve 0-1"), (Change{.e = -1, .f = -1}));
  EXPECT_TRUE(mesh.has_rings(Face(0)));
}

TEST(dissolve_edge, refusals_name_their_rule) {
  EXPECT_EQ(rules_against(make_mesh(two_quads()), "dissolve 2-3"), "boundary");
  EXPECT_EQ(rules_against(make_mesh(fin()), "dissolve 0-1@f0"), "boundary copies");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}, {0, 2, 1}}), "dissolve 0-1"), "loop");
  // The two share another edge, with a face between.
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2, 3}, {1, 0, 3, 4}}), "dissolve 0-1"), "");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2, 3, 4, 5}, {1, 0, 6, 4, 3, 7}}), "dissolve 0-1"), "loop");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}, {2, 1, 3}, {0, 3, 4}, {3, 0, 2}}), "dissolve 1-2"), "");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}, {2, 1, 3}, {0, 1, 3, 2}}), "dissolve 1-2"), "duplicate_face");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}, {2, 1, 3}, {0, 2, 1}}), "dissolve 1-2@f0").empty(), false);
}

TEST(dissolve_edge, a_bridge_is_refused) {
  const Mesh mesh = make_mesh({{0, 1, 2, 3, 0, 4, 6, 5, 4}});
  EXPECT_EQ(rules_against(mesh, "dissolve 0-4").substr(0, 9), "same_face");
}

TEST(dissolve_vertex, takes_a_poke_back) {
  Mesh mesh = make_mesh(closed_fan(6));
  EXPECT_EQ(apply_and_prove(mesh, "dissolve v0"), (Change{.v = -1, .e = -6, .f = -5}));
  EXPECT_EQ(point_polygons(mesh), (Polygons{{1, 2, 3, 4, 5, 6}}));
}

TEST(dissolve_vertex, on_the_boundary_it_goes_with_its_last_two_edges) {
  // 0 is on the boundary of three triangles 0-1-2, 0-2-3, 0-3-4.
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  EXPECT_EQ(apply_and_prove(mesh, "dissolve v0"), (Change{.v = -1, .e = -3, .f = -2}));
  EXPECT_EQ(point_polygons(mesh), (Polygons{{1, 2, 3, 4}}));
}

TEST(dissolve_vertex, on_the_boundary_it_stays_where_it_must) {
  // 1-4 is an edge elsewhere, so 0 stays as a corner.
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {4, 1, 5}});
  EXPECT_EQ(apply_and_prove(mesh, "dissolve v0"), (Change{.e = -2, .f = -2}));
  EXPECT_TRUE(mesh.is_alive(Vertex(0)));
  // Two triangles leave a triangle with 0 in the middle of a side: it goes; one leaves nothing to go.
  Mesh two = make_mesh({{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(apply_and_prove(two, "dissolve v0"), (Change{.v = -1, .e = -2, .f = -1}));
  EXPECT_EQ(point_polygons(two), (Polygons{{1, 2, 3}}));
}

TEST(dissolve_vertex, with_two_edges_it_goes_as_by_unite_edge) {
  Mesh mesh = make_mesh({{0, 1, 2, 3}, {2, 1, 0, 4}});
  EXPECT_EQ(apply_and_prove(mesh, "dissolve v1"), (Change{.v = -1, .e = -1}));
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}}), "dissolve v1"), "edge_exists loop");
}

TEST(dissolve_vertex, chains_of_its_edges_go_as_one) {
  // 4 lies on the edge from the middle 0 to 1.
  Mesh mesh = make_mesh({{0, 4, 1, 2}, {0, 2, 3}, {0, 3, 1, 4}});
  EXPECT_EQ(apply_and_prove(mesh, "dissolve v0"), (Change{.v = -2, .e = -4, .f = -2}));
  EXPECT_EQ(point_polygons(mesh), (Polygons{{1, 2, 3}}));
}

TEST(dissolve_vertex, a_wire_keeps_it) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
  apply_and_prove(mesh, "make_edge 0 4");
  EXPECT_EQ(apply_and_prove(mesh, "dissolve v0"), (Change{.e = -1, .f = -1}));
  EXPECT_TRUE(find_halfedge(mesh, Vertex(0), Vertex(4)));
}

TEST(dissolve_vertex, refusals_name_their_rule) {
  EXPECT_EQ(rules_against(make_mesh(tetrahedron()), "dissolve v0"), "duplicate_face");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}}, 4), "dissolve v3"), "nothing_between");
  Polygons doubled = closed_fan(4);
  doubled.push_back({0, 2, 1});
  EXPECT_NE(rules_against(make_mesh(doubled), "dissolve v0@f0"), "");
  // Both points of a bow of closed fans are copies.
  Polygons bow = closed_fan(3);
  for (const std::vector<std::uint32_t>& face : {std::vector<std::uint32_t>{0, 4, 5}, {0, 5, 6}, {0, 6, 4}})
    bow.push_back(face);
  EXPECT_EQ(rules_against(make_mesh(bow), "dissolve v0@f0"), "copies");
}

TEST(dissolve_vertex, a_split_makes_the_tetrahedron_legal) {
  Mesh mesh = make_mesh(tetrahedron());
  const std::vector<std::string> remedy = find_remedy(mesh, Dissolve{{}, Vertex(0)});
  ASSERT_FALSE(remedy.empty());
  for (const std::string& step : remedy) apply_and_prove(mesh, step);
  EXPECT_EQ(rules_against(mesh, "dissolve v0"), "");
}

TEST(dissolve, lines_that_say_no_operator) {
  Mesh mesh = make_mesh({{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(parse_error(mesh, "dissolve"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "dissolve f0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "dissolve 0-1 2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "dissolve v9"), NameError::never_existed);
  EXPECT_EQ(parse_error(mesh, "dissolve 0-3"), NameError::never_existed);
  apply_and_prove(mesh, "delete f1");
  EXPECT_EQ(parse_error(mesh, "dissolve v3"), NameError::deleted);
  EXPECT_EQ(parse_error(mesh, "dissolve 3-4"), NameError::deleted);
}

}  // namespace
}  // namespace ryosen
