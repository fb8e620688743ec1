#include "ryosen/ops/extrude_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Mesh square_at_origin() {
  IndexedMesh source = indexed({{0, 1, 2, 3}});
  source.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  return from_indexed(std::move(source));
}

TEST(extrude_edges, the_surface_goes_on_across_an_edge) {
  Mesh mesh = square_at_origin();
  EXPECT_EQ(apply_and_prove(mesh, "extrude_edges 1-2"), (Change{.v = 2, .e = 3, .f = 1}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 2, 3}, {2, 1, 4, 5}}));
  EXPECT_EQ(mesh.position(Vertex(4)), glm::dvec3(4, 0, 0)) << "away from the face, as far as the edge is long";
  EXPECT_EQ(mesh.position(Vertex(5)), glm::dvec3(4, 2, 0));
  EXPECT_FALSE(compute_figures(mesh)[ProblemKind::misoriented_edge]);
}

TEST(extrude_edges, a_chain_goes_as_one_and_an_edge_that_is_named_twice_counts_once) {
  Mesh mesh = square_at_origin();
  EXPECT_EQ(apply_and_prove(mesh, "extrude_edges 0-1 1-2 1-0 0,0,3"), (Change{.v = 3, .e = 5, .f = 2}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 2, 3}, {1, 0, 4, 5}, {2, 1, 5, 6}}));
  EXPECT_EQ(mesh.position(Vertex(5)), glm::dvec3(2, 0, 3));
}

// The ways out of the square cancel out.
TEST(extrude_edges, around_a_face_it_rises_along_the_normal_as_a_box) {
  Mesh mesh = square_at_origin();
  EXPECT_EQ(apply_and_prove(mesh, "extrude_edges 0-1 1-2 2-3 3-0 5"), (Change{.v = 4, .e = 8, .f = 4}));
  EXPECT_EQ(mesh.position(Vertex(4)), glm::dvec3(0, 0, 5));
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.manifold);
  EXPECT_EQ(figures[ProblemKind::boundary_loop], 4u) << "the edges on top";
}

TEST(extrude_edges, a_wire_becomes_a_side_as_it_is_named) {
  for (const auto& [line, face] : {std::pair("extrude_edges 1-0 0,0,1", std::vector<std::uint32_t>{1, 0, 3, 2}),
                                   std::pair("extrude_edges 0-1 0,0,1", std::vector<std::uint32_t>{0, 1, 3, 2})}) {
    Mesh mesh = make_mesh({}, 2);
    apply_and_prove(mesh, "make_edge 0 1");
    EXPECT_EQ(apply_and_prove(mesh, line), (Change{.v = 2, .e = 3, .f = 1})) << line;
    EXPECT_EQ(polygons_of(mesh), Polygons{face}) << line;
  }
}

TEST(extrude_edges, an_edge_between_two_faces_gets_a_third) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}});
  apply_and_prove(mesh, "extrude_edges 0-1 0,0,1");
  EXPECT_EQ(polygons_of(mesh).size(), 3u);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::nonmanifold_edge], 1u);
}

// However they are named, and the numbers of whose points come first.
TEST(extrude_edges, chains_and_loops_run_on_where_they_may) {
  for (const char* loop : {"0-1 1-3 3-2 2-0", "0-1 0-2 1-3 2-3", "2-3 0-1 0-2 1-3"}) {
    Mesh box = make_mesh(cube());
    apply_and_prove(box, std::string("extrude_edges ") + loop + " 0,0,1");
    EXPECT_EQ(compute_figures(box)[ProblemKind::misoriented_edge], 0u) << loop;
    EXPECT_EQ(compute_figures(box).faces, 10u) << loop;
  }
  for (const char* named : {"0-1 1-2 2-3", "2-3 1-2 0-1", "1-2 1-0 2-3", "3-2 0-1 2-1"}) {
    Mesh wires = make_mesh({}, 4);
    for (const char* wire : {"make_edge 0 1", "make_edge 1 2 0-1", "make_edge 2 3 1-2"}) apply_and_prove(wires, wire);
    apply_and_prove(wires, std::string("extrude_edges ") + named + " 0,0,1");
    EXPECT_EQ(compute_figures(wires)[ProblemKind::misoriented_edge], 0u) << named;
    EXPECT_EQ(compute_figures(wires).components, 1u) << named;
  }
}

TEST(extrude_edges, the_way_along_the_normal_does_not_depend_on_the_order_of_names) {
  IndexedMesh source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  source.face_offsets = {0};
  Mesh mesh = from_indexed(source);
  for (const char* wire : {"make_edge 0 1", "make_edge 1 2 0-1"}) apply_and_prove(mesh, wire);
  EXPECT_EQ(std::get<ExtrudeEdges>(op_of(mesh, "extrude_edges 0-1 1-2 1")).movement(mesh), glm::dvec3(0, 0, 1));
  EXPECT_EQ(std::get<ExtrudeEdges>(op_of(mesh, "extrude_edges 1-2 0-1 1")).movement(mesh), glm::dvec3(0, 0, 1));
}

// A hole in a plate that leans, with places of as many digits as files have.
TEST(extrude_edges, around_a_hole_what_rounding_leaves_of_the_ways_out_is_no_way) {
  IndexedMesh source = indexed({{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
  const glm::dvec3 u = glm::normalize(glm::dvec3(3, 1, 2)), v = glm::normalize(glm::cross(u, glm::dvec3(1, -2, 5)));
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; i < 8; ++i) {
    const double size = i < 4 ? 3 : 1, from = i < 4 ? 0 : 1;
    const glm::dvec3 p = (from + size * corners[i % 4][0]) * u + (from + size * corners[i % 4][1]) * v;
    source.positions[i] = {rounded(p.x), rounded(p.y), rounded(p.z)};
  }
  const Mesh mesh = from_indexed(source);
  const glm::dvec3 by = std::get<ExtrudeEdges>(op_of(mesh, "extrude_edges 4-5 5-6 6-7 7-4 1")).movement(mesh);
  EXPECT_NEAR(std::abs(glm::dot(by, glm::normalize(glm::cross(u, v)))), 1, 1e-4);
}

// More than two quads stand on the edge that rises from the point where they meet.
TEST(extrude_edges, wires_that_branch_rise_as_a_book) {
  Mesh mesh = make_mesh({}, 4);
  for (const char* wire : {"make_edge 0 1", "make_edge 0 2 1-0", "make_edge 0 3 1-0"}) apply_and_prove(mesh, wire);
  apply_and_prove(mesh, "extrude_edges 0-1 0-2 0-3 0,0,1");
  const Figures figures = compute_figures(mesh);
  EXPECT_EQ(figures.faces, 3u);
  EXPECT_EQ(figures[ProblemKind::nonmanifold_edge], 1u);
  EXPECT_EQ(figures.edges, 3u + 3u + 4u) << "base, top and up";
}

TEST(extrude_edges, a_bridge_is_refused) {
  IndexedMesh source = indexed({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  source.positions = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 6, 0}};
  const Mesh mesh = from_indexed(std::move(source));
  EXPECT_EQ(rules_against(mesh, "extrude_edges 0-4"), "same_face");
  EXPECT_EQ(rules_against(mesh, "extrude_edges 0-1 0-4"), "same_face");
  EXPECT_EQ(rules_against(mesh, "extrude_edges 0-1"), "");
}

std::string warned(const Mesh& mesh, const std::string& line) {
  std::string names;
  for (const Reason& reason : warnings(mesh, op_of(mesh, line))) {
    names += std::string(text_of(reason.rule).id) + ":";
    for (const Element& e : reason.witnesses) names += " " + name_of(mesh, e);
  }
  return names;
}

TEST(extrude_edges, warns_of_flat_quads_and_of_pinched_points) {
  const Mesh square = square_at_origin();
  EXPECT_EQ(warned(square, "extrude_edges 0-1 1"), "");
  EXPECT_EQ(warned(square, "extrude_edges 0-1 3,0,0"), "degenerate: 0-1") << "along itself";
  EXPECT_EQ(warned(square, "extrude_edges 0-1 0"), "degenerate: 0-1");
  Mesh tail = make_mesh({{0, 1, 2}}, 4);
  apply_and_prove(tail, "make_edge 0 3");
  EXPECT_EQ(warned(tail, "extrude_edges 0-3 0.3,0.2,9"), "pinch: v0") << "a quad touches the triangle at a point";
  EXPECT_EQ(warned(tail, "extrude_edges 0-3 0-1 0.3,0.2,9"), "") << "the other quad lies between";
}

TEST(extrude_edges, has_no_way_of_its_own_along_a_straight_wire) {
  IndexedMesh source;
  source.positions = {{0, 0, 0}, {1, 0, 0}};
  source.face_offsets = {0};
  Mesh mesh = from_indexed(source);
  apply_and_prove(mesh, "make_edge 0 1");
  EXPECT_EQ((ExtrudeEdges{{halfedge(Edge(0))}}.movement(mesh)), glm::dvec3(0));
  EXPECT_EQ(warned(mesh, "extrude_edges 0-1"), "degenerate: 0-1");
}

TEST(extrude_edges, parse_errors) {
  const Mesh mesh = square_at_origin();
  EXPECT_EQ(parse_error(mesh, "extrude_edges"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude_edges f0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude_edges 0-1 1 2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude_edges 0-1 1,2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude_edges 0-1 nan"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "extrude_edges 0-9"), NameError::never_existed);
  EXPECT_EQ(parse_error(mesh, "extrude_edges 0-1 1e400"), NameError::malformed);
  EXPECT_TRUE(parse_line(mesh, "extrude_edges 0-1 1e400").sentence.en.starts_with("'1e400' is not understood"))
      << "no name of an edge";
}

TEST(extrude_edges, says_a_line_that_does_the_same) {
  const Mesh mesh = square_at_origin();
  for (const char* line :
       {"extrude_edges 0-1 1-2", "extrude_edges 0-1 1e-05", "extrude_edges 2-1 -0.5", "extrude_edges 0-1 3-0 1,2,-3"})
    EXPECT_EQ(command_of(mesh, op_of(mesh, line)), line);
}

TEST(extrude_edges, a_place_that_is_not_finite_stays_where_it_is) {
  IndexedMesh source = indexed({{0, 1, 2}});
  source.positions = {{0, 0, 0}, {std::nan(""), 0, 0}, {0, 1, 0}};
  Mesh mesh = from_indexed(source);
  ASSERT_TRUE(try_apply(mesh, nullptr, op_of(mesh, "extrude_edges 0-1 1-2 2-0 0,0,1")));
  EXPECT_FALSE(check_invariants(mesh));
  EXPECT_EQ(mesh.position(Vertex(3)), glm::dvec3(0, 0, 1));
  EXPECT_TRUE(std::isnan(mesh.position(Vertex(4)).x));
}

}  // namespace
}  // namespace ryosen
