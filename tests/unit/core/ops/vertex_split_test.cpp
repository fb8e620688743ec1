#include "ryosen/ops/vertex_split.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// A flat star: 0 in the middle of a regular polygon.
Mesh star(std::uint32_t spokes) {
  IndexedMesh source = indexed(closed_fan(spokes));
  source.positions[0] = {};
  for (std::uint32_t i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / spokes;
    source.positions[1 + i] = {std::cos(angle), std::sin(angle), 0};
  }
  return from_indexed(std::move(source));
}

TEST(vertex_split, inside_it_makes_an_edge_and_two_triangles) {
  Mesh mesh = star(6);
  EXPECT_EQ(apply_and_prove(mesh, "vertex_split v0 v1 v4"), (Change{.v = 1, .e = 3, .f = 2}));
  EXPECT_EQ(point_polygons(mesh),
            (Polygons{{0, 1, 7}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}, {0, 7, 4}, {1, 2, 7}, {2, 3, 7}, {3, 4, 7}}));
}

TEST(vertex_split, at_the_boundary_with_one_triangle) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 3}});
  Mesh right = mesh;
  EXPECT_EQ(apply_and_prove(mesh, "vertex_split v0 v2 -"), (Change{.v = 1, .e = 2, .f = 1}));
  EXPECT_EQ(point_polygons(mesh), (Polygons{{0, 1, 2}, {0, 2, 4}, {2, 3, 4}}));
  EXPECT_EQ(apply_and_prove(right, "vertex_split v0 - v2"), (Change{.v = 1, .e = 2, .f = 1}));
  EXPECT_EQ(point_polygons(right), (Polygons{{0, 2, 3}, {0, 4, 2}, {1, 2, 4}}));
}

TEST(vertex_split, may_take_the_gap_or_a_bare_side) {
  Mesh gap = make_mesh({{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(apply_and_prove(gap, "vertex_split v0 v3 v1"), (Change{.v = 1, .e = 3, .f = 2}));
  EXPECT_FALSE(gap.is_boundary(Vertex(0)));
  Mesh side = make_mesh({{0, 1, 2}});
  EXPECT_EQ(apply_and_prove(side, "vertex_split v0 v2 -"), (Change{.v = 1, .e = 2, .f = 1}));
  EXPECT_EQ(point_polygons(side), (Polygons{{0, 1, 2}, {0, 2, 3}}));
}

TEST(vertex_split, a_collapse_takes_it_back) {
  const std::vector<Polygons> shapes{tetrahedron(), cube(),          torus_grid(3, 3),
                                     two_quads(),   closed_fan(5),   bow_tie(),
                                     fin(),         moebius_strip(), two_tetrahedra_on_an_edge()};
  std::vector<Mesh> meshes;
  for (const Polygons& faces : shapes) meshes.push_back(make_mesh(faces));
  for (std::uint64_t seed = 1; seed <= (is_long_run() ? 60u : 8u); ++seed)
    meshes.push_back(make_mesh(seeded_mesh(seed).faces, seeded_mesh(seed).points));
  std::size_t done = 0;
  for (const Mesh& start : meshes) {
    for (std::uint32_t i = 0; i < start.vertex_slots(); ++i) {
      if (start.is_isolated(Vertex(i))) continue;
      std::vector<Halfedge> ends{Halfedge()};
      for (Halfedge h : outgoing(start, Vertex(i))) ends.push_back(h);
      for (Halfedge left : ends) {
        for (Halfedge right : ends) {
          const VertexSplit op{Vertex(i), left, right};
          if (left == right || !check(start, AnyOp(op)).legal()) continue;
          Mesh mesh = start;
          const Vertex fresh(mesh.vertex_slots());
          apply_and_prove(mesh, op);
          apply_and_prove(mesh, CollapseEdge{find_halfedge(mesh, fresh, Vertex(i)), CollapseEdge::Place::end});
          EXPECT_EQ(point_polygons(mesh), point_polygons(start)) << command_of(start, op);
          EXPECT_EQ(mesh.live(), start.live());
          if (HasFailure()) return;
          ++done;
        }
      }
    }
  }
  EXPECT_GT(done, is_long_run() ? 2000u : 1000u);
}

TEST(vertex_split, turns_nothing_over_on_convex_stars) {
  for (std::uint32_t spokes = 3; spokes <= 9; ++spokes) {
    for (std::uint32_t l = 1; l <= spokes; ++l) {
      for (std::uint32_t r = 1; r <= spokes; ++r) {
        if (l == r) continue;
        Mesh mesh = star(spokes);
        const AnyOp op = op_of(mesh, "vertex_split v0 v" + std::to_string(l) + " v" + std::to_string(r));
        EXPECT_TRUE(warnings(mesh, op).empty()) << command_of(mesh, op) << " of " << spokes;
        apply_and_prove(mesh, op);
        for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
          FaceGeometry face, up{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
          for (Vertex v : vertices_around(mesh, Face(f))) face.add(mesh.position(v));
          EXPECT_FALSE(face.is_degenerate() || up.turns_against(face)) << command_of(mesh, op);
        }
      }
    }
  }
}

TEST(vertex_split, a_place_can_be_chosen_and_is_warned_about) {
  Mesh mesh = star(6);
  EXPECT_EQ(warnings(mesh, op_of(mesh, "vertex_split v0 v1 v4 5,-5,0"))[0].rule, Rule::normal_turns);
  EXPECT_EQ(warnings(mesh, op_of(mesh, "vertex_split v0 v1 v4 0.5,0,0"))[0].rule, Rule::degenerate);
  apply_and_prove(mesh, "vertex_split v0 v1 v4 0,0.5,0");
  EXPECT_EQ(mesh.position(Vertex(7)), glm::dvec3(0, 0.5, 0));
}

TEST(vertex_split, refusals_name_their_rule) {
  EXPECT_EQ(rules_against(make_mesh(closed_fan(4)), "vertex_split v0 v1 -"), "no_gap");
  EXPECT_EQ(rules_against(make_mesh(closed_fan(4)), "vertex_split v0 v1 v1"), "same_vertex");
  EXPECT_EQ(rules_against(make_mesh({{0, 1, 2}, {0, 2, 1}}), "vertex_split v0 v1 v2"), "loses_duplicate");
  EXPECT_EQ(rules_against(make_mesh(fin()), "vertex_split v0@f0 - v1"), "copies");
  EXPECT_EQ(rules_against(make_mesh(fin()), "vertex_split v0@f0 v1 -"), "") << "a triangle takes the place of f0";
  Mesh wire = make_mesh({{0, 1, 2}}, 4);
  apply_and_prove(wire, "make_edge 0 3");
  EXPECT_EQ(rules_against(wire, "vertex_split v0 v3 v1"), "wire");
  Mesh bridge = make_mesh({{0, 1, 2, 3, 0, 4, 6, 5, 4}});
  EXPECT_EQ(rules_against(bridge, "vertex_split v0 v3 v4"), "loop");
}

TEST(vertex_split, other_fans_of_the_vertex_stay_with_it) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
  apply_and_prove(mesh, "make_edge 0 4");
  // The wire lies in the gap, so whoever takes the gap takes it.
  Mesh takes = mesh;
  apply_and_prove(takes, "vertex_split v0 v3 v1");
  EXPECT_TRUE(find_halfedge(takes, Vertex(7), Vertex(4)));
  apply_and_prove(mesh, "vertex_split v0 v1 v3");
  EXPECT_TRUE(find_halfedge(mesh, Vertex(0), Vertex(4)));
}

TEST(vertex_split, lines_that_say_no_operator) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(parse_error(mesh, "vertex_split"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "vertex_split v0 v1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "vertex_split v0 - -"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "vertex_split v0 v1 v2 here"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "vertex_split v0 v1 v2 0,0,0 1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "vertex_split v1 v0 v3"), NameError::never_existed);
  EXPECT_EQ(parse_error(mesh, "vertex_split v9 v0 v3"), NameError::never_existed);
  apply_and_prove(mesh, "delete f2");
  EXPECT_EQ(parse_error(mesh, "vertex_split v4 v5 -"), NameError::deleted);
}

}  // namespace
}  // namespace ryosen
