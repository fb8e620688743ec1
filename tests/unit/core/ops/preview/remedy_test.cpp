#include "ryosen/ops/preview/remedy.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/circulate.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

void apply_line(Mesh& mesh, const std::string& line) {
  const ParsedOp parsed = parse_line(mesh, line);
  ASSERT_TRUE(parsed.op) << line;
  Edit edit(mesh, nullptr);
  apply(edit, *parsed.op);
  edit.commit();
}

void expect_remedy_works(const Polygons& faces, const std::string& line) {
  Mesh mesh = make_mesh(faces);
  const MeshColumns before = mesh.columns();
  const ParsedOp op = parse_line(mesh, line);
  ASSERT_TRUE(op.op);
  ASSERT_FALSE(check(mesh, *op.op).legal());
  const std::vector<std::string> remedy = find_remedy(mesh, *op.op);
  EXPECT_EQ(mesh.columns(), before);
  ASSERT_FALSE(remedy.empty()) << line;
  for (const std::string& step : remedy) apply_line(mesh, step);
  const ParsedOp again = parse_line(mesh, line);
  ASSERT_TRUE(again.op);
  EXPECT_TRUE(check(mesh, *again.op).legal()) << line << " after " << remedy[0];
}

TEST(remedy, makes_the_operator_legal) {
  expect_remedy_works(tetrahedron(), "collapse 0-1");
  expect_remedy_works(tetrahedron(), "swap 0-1");
  expect_remedy_works({{0, 1, 2}}, "collapse 0-1");
  expect_remedy_works({{0, 1, 2}, {0, 2, 1}}, "collapse 0-1");
  expect_remedy_works({{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}, "collapse 0-1");
  expect_remedy_works({{0, 1, 2}, {0, 1, 3}}, "swap 0-1@f0");
}

// The points 0 and 1 are corners of each face, which a step divides.
TEST(remedy, there_is_none_where_more_faces_hold_both_points_than_it_has_steps) {
  const auto faces = [](std::uint32_t count) {
    Polygons all;
    for (std::uint32_t i = 0; i < count; ++i) all.push_back({0, 4 * i + 2, 4 * i + 3, 1, 4 * i + 4, 4 * i + 5});
    return all;
  };
  Mesh mesh = make_mesh(faces(3));
  EXPECT_EQ(RemedySearch(mesh).find("weld 0 1").size(), 3u);
  mesh = make_mesh(faces(5));
  EXPECT_TRUE(RemedySearch(mesh).find("weld 0 1").empty());
}

std::vector<std::string> remedy_for(const Polygons& faces, const std::string& line) {
  Mesh mesh = make_mesh(faces);
  return RemedySearch(mesh).find(line);
}

TEST(remedy, keeps_what_the_line_names) {
  const Polygons pair{{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(remedy_for(pair, "split 0-1@f0"), std::vector<std::string>{"delete_loop f1"});
  EXPECT_EQ(remedy_for(pair, "split 0-1@f1"), std::vector<std::string>{"delete_loop f0"});
  const Polygons twice{{0, 1, 2}, {0, 1, 2}};
  EXPECT_EQ(remedy_for(twice, "poke f0"), std::vector<std::string>{"delete_loop f1"});
  EXPECT_EQ(remedy_for(twice, "poke f1"), std::vector<std::string>{"delete_loop f0"});
}

// Turned once on a copy for all questions; each answer is that of a search of its own, and the mesh stays.
TEST(remedy, of_many_questions_is_that_of_each_alone) {
  Mesh mesh = make_mesh(moebius_strip());
  const MeshColumns before = mesh.columns();
  RemedySearch search(mesh);
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
    for (const AnyOp& op : {AnyOp(CollapseEdge{Halfedge(i)}), AnyOp(SwapEdge{Halfedge(i)})}) {
      const std::string line = command_of(mesh, op);
      const std::vector<std::string> remedy = search.find(line);
      EXPECT_EQ(remedy, RemedySearch(mesh).find(line)) << line;
      found += !remedy.empty();
    }
  EXPECT_GT(found, 0u);
  EXPECT_EQ(mesh.columns(), before);
}

TEST(remedy, there_is_none_for_a_legal_line_or_one_that_names_nothing) {
  EXPECT_TRUE(remedy_for(cube(), "split 0-1").empty());
  EXPECT_TRUE(remedy_for(cube(), "split 0-77").empty());
  EXPECT_TRUE(remedy_for(cube(), "nothing").empty());
}

// The slot of an edge may be another edge once faces have turned.
TEST(remedy, speaks_of_the_same_edge_when_it_is_named_by_its_slot) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 1, 3}});
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    Mesh trial = mesh;
    const std::string line = "swap h" + std::to_string(i);
    const ParsedOp asked = parse_line(trial, line);
    if (!asked.op) continue;
    const std::string plain = command_of(trial, *asked.op);
    const std::vector<std::string> remedy = RemedySearch(trial).find(line);
    if (remedy.empty()) continue;
    for (const std::string& step : remedy) apply_line(trial, step);
    const ParsedOp named = parse_line(trial, plain), again = parse_line(trial, line);
    ASSERT_TRUE(named.op && again.op) << line;
    EXPECT_EQ(command_of(trial, *named.op), command_of(trial, *again.op)) << line;
  }
}

TEST(remedy, there_is_none_on_the_boundary_of_a_lone_triangle) {
  Mesh mesh = make_mesh({{0, 1, 2}});
  EXPECT_TRUE(find_remedy(mesh, SwapEdge{find_halfedge(mesh, Vertex(0), Vertex(1))}).empty());
}

}  // namespace
}  // namespace ryosen
