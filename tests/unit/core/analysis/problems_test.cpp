#include "ryosen/analysis/problems.h"

#include <gtest/gtest.h>

#include <limits>

#include "ryosen/mesh/circulate.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

struct Case {
  Mesh mesh;
  std::vector<QuarantinedFace> quarantine;
  std::vector<std::uint32_t> lines;

  FileFaces file() const { return {quarantine, lines}; }
  std::vector<Problem> problems() const { return find_problems(mesh, ProblemSets(mesh), file()); }
  std::vector<std::string> names(const Problem& problem) const {
    std::vector<std::string> names;
    for (Element e : problem.elements) names.push_back(name_on_points(mesh, e));
    return names;
  }
};

// Faces stand on the lines 101, 102, ...
Case case_of(const Polygons& faces, std::size_t points = 0) {
  Case result{make_mesh(faces, points), {}, {}};
  for (std::uint32_t i = 0; i < faces.size(); ++i) result.lines.push_back(101 + i);
  return result;
}

std::vector<std::string_view> ids(const std::vector<Problem>& problems) {
  std::vector<std::string_view> ids;
  for (const Problem& p : problems) ids.push_back(p.row().id);
  return ids;
}

using Strings = std::vector<std::string>;
using Ids = std::vector<std::string_view>;

TEST(problems, closed_manifolds_have_none) { EXPECT_TRUE(case_of(cube()).problems().empty()); }

TEST(problems, boundary_loops_are_listed_as_info) {
  const Case c = case_of({{0, 1, 2}, {3, 4, 5}});
  const auto problems = c.problems();
  ASSERT_EQ(ids(problems), (Ids{"boundary_loop"}));
  EXPECT_EQ(problems[0].row().severity, ProblemSeverity::info);
  EXPECT_EQ(problems[0].count(), 2u);
  EXPECT_EQ(c.names(problems[0]), (Strings{"0-1", "3-4"}));
  EXPECT_EQ(problems[0].text.en, "The surface has 2 boundary loops.");
}

TEST(problems, of_three_faces_on_an_edge_name_points_and_the_last_line) {
  const Case c = case_of(fin());
  const auto problems = c.problems();
  ASSERT_EQ(ids(problems), (Ids{"nonmanifold_edge", "nonmanifold_vertex"}));
  EXPECT_EQ(c.names(problems[0]), (Strings{"0-1"}));
  EXPECT_EQ(problems[0].line, 103u);
  EXPECT_EQ(problems[0].where, 0.5 * (c.mesh.position(Vertex(0)) + c.mesh.position(Vertex(1))));
  EXPECT_EQ(problems[0].text.en, "One edge carries three or more faces.");
  EXPECT_EQ(c.names(problems[1]), (Strings{"v0", "v1"}));
  EXPECT_EQ(problems[1].line, 103u);
  EXPECT_EQ(problems[1].row().severity, ProblemSeverity::problem);
}

TEST(problems, of_a_bow_tie) {
  const Case c = case_of(bow_tie());
  const auto problems = c.problems();
  ASSERT_EQ(ids(problems), (Ids{"nonmanifold_vertex", "boundary_loop"}));
  EXPECT_EQ(c.names(problems[0]), (Strings{"v0"}));
  EXPECT_EQ(problems[0].line, 102u);
}

TEST(problems, of_faces) {
  Polygons faces = tetrahedron();
  faces.push_back({1, 0, 2});
  faces.push_back({0, 4, 5});
  faces.push_back({5, 4, 0});
  Case c = case_of(faces, 8);
  const auto problems = c.problems();
  EXPECT_EQ(ids(problems),
            (Ids{"nonmanifold_edge", "nonmanifold_vertex", "duplicate_face", "hanging_pair", "isolated_vertex"}));
  EXPECT_EQ(c.names(problems[2]), (Strings{"f4", "f6"}));
  EXPECT_EQ(problems[2].line, 105u);
  EXPECT_EQ(c.names(problems[3]), (Strings{"f6"}));
  EXPECT_EQ(problems[3].line, 107u);
  EXPECT_EQ(c.names(problems[4]), (Strings{"v6", "v7"}));
  EXPECT_EQ(problems[4].line, 0u);
  EXPECT_EQ(problems[4].where, c.mesh.position(Vertex(6)));
}

TEST(problems, of_places) {
  IndexedMesh source = indexed({{0, 1, 2}, {3, 4, 5}});
  source.positions[2] = 2.0 * source.positions[1] - source.positions[0];
  source.positions[4].x = std::numeric_limits<double>::quiet_NaN();
  const Case c{from_indexed(std::move(source)), {}, {7, 8}};
  const auto problems = c.problems();
  ASSERT_EQ(ids(problems), (Ids{"degenerate_area", "nonfinite_vertex", "boundary_loop"}));
  EXPECT_EQ(c.names(problems[0]), (Strings{"f0"}));
  EXPECT_EQ(problems[0].line, 7u);
  EXPECT_EQ(c.names(problems[1]), (Strings{"v4"}));
  EXPECT_FALSE(problems[1].where);
  EXPECT_EQ(problems[1].line, 8u);
}

// By the lines of the vertices, all of a place together.
TEST(problems, of_points_that_lie_on_others) {
  IndexedMesh source = indexed({{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
  source.positions[4] = source.positions[7] = source.positions[1];
  source.positions[8] = source.positions[0];
  const Mesh mesh = from_indexed(std::move(source));
  const ProblemSets sets(mesh);
  const auto problems = find_problems(mesh, sets, {});
  ASSERT_EQ(ids(problems), (Ids{"boundary_loop", "coincident_points"}));
  const Problem& found = problems[1];
  EXPECT_EQ(found.elements, (std::vector<Element>{Vertex(0), Vertex(1), Vertex(4), Vertex(7), Vertex(8)}));
  EXPECT_EQ(found.text.en, "5 vertices lie on others.");
  EXPECT_EQ(found.row().severity, ProblemSeverity::info);
  Neighbourhood around(mesh);
  const auto all_at = [&](std::uint32_t v) {
    return about(found.row(), around, sets.of(ProblemKind::coincident_points), Vertex(v));
  };
  EXPECT_EQ(all_at(4), (std::vector<Element>{Vertex(4), Vertex(1), Vertex(7)}));
  EXPECT_EQ(all_at(0), (std::vector<Element>{Vertex(0), Vertex(8)}));
}

TEST(problems, of_misoriented_neighbours) {
  const Case c = case_of({{0, 1, 2}, {0, 1, 3}});
  const auto problems = c.problems();
  ASSERT_EQ(ids(problems), (Ids{"misoriented_edge", "boundary_loop"}));
  EXPECT_EQ(c.names(problems[0]), (Strings{"0-1"}));
  EXPECT_EQ(problems[0].line, 102u);
}

TEST(problems, of_the_quarantine) {
  IndexedMesh source = indexed({{0, 1, 2}, {}, {}});
  QuarantinedFace repeated, short_one;
  repeated.face = 1;
  repeated.line = 31;
  repeated.corners = {1, 2, 1};
  short_one.face = 2;
  short_one.line = 32;
  short_one.corners = {0, 9};
  source.quarantine = {repeated, short_one};
  Case c{make_mesh({}), source.quarantine, {}};
  c.mesh = from_indexed(source);
  const auto problems = c.problems();
  ASSERT_EQ(ids(problems), (Ids{"degenerate_repeat", "quarantined_face", "boundary_loop"}));
  EXPECT_EQ(c.names(problems[0]), (Strings{"f1"}));
  EXPECT_EQ(problems[0].line, 31u);
  EXPECT_EQ(c.names(problems[1]), (Strings{"f1", "f2"}));
  EXPECT_EQ(place_of(c.mesh, Face(2), c.file()), c.mesh.position(Vertex(0)));
  EXPECT_EQ(line_of(c.mesh, ProblemKind::quarantined_face, Face(2), c.file()), 32u);
}

}  // namespace
}  // namespace ryosen
