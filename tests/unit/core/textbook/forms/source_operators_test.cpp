#include "ryosen/textbook/forms/source_operators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/all.h"
#include "ryosen/textbook/forms/walk.h"
#include "tests/support/core/shapes.h"

namespace ryosen::forms {
namespace {

using Triangles = std::vector<std::vector<std::uint32_t>>;

// Each from its smallest vertex, sorted.
Triangles sorted(Triangles triangles) {
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Triangles triangles_of(const HalfedgeTable& table) {
  Triangles triangles;
  for (const std::uint32_t first : table.face_halfedge) {
    if (first == no_index) continue;
    triangles.emplace_back();
    for_each_in_loop(table, first, [&](std::uint32_t h) { triangles.back().push_back(table.from(h)); });
  }
  return sorted(triangles);
}

// Every link of what is left agrees with every other.
void expect_sound(const HalfedgeTable& table) {
  for (std::uint32_t h = 0; h < table.halfedges.size(); ++h) {
    if (table.from(h) == no_index) continue;
    EXPECT_EQ(table.pair(table.pair(h)), h);
    EXPECT_EQ(table.from(table.pair(h)), table.from(table.next(h)));
    EXPECT_EQ(table.prev(table.next(h)), h);
  }
  for (std::uint32_t v = 0; v < table.vertex_halfedge.size(); ++v)
    if (const std::uint32_t h = table.vertex_halfedge[v]; h != no_index) {
      EXPECT_EQ(table.from(h), v);
    }
}

Mesh octahedron() {
  return test::make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
}

// On closed triangles the steps of the source texts and the operators of the kernel give the same model.
template <class Op>
std::size_t compare_on_every_edge(const Mesh& mesh, SourceOutcome (*texts)(HalfedgeTable&, std::uint32_t)) {
  std::size_t compared = 0;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    Op op{Halfedge(i)};
    if constexpr (std::is_same_v<Op, CollapseEdge>) op.place = CollapseEdge::Place::middle;
    if (!op.check(mesh).legal()) continue;
    HalfedgeTable table = inner_halfedges(mesh);
    const Vertex from = mesh.from(op.halfedge), to = mesh.to(op.halfedge);
    std::uint32_t h = find_side(table, from.index, to.index);
    if (table.from(h) != from.index) h = table.pair(h);
    const SourceOutcome outcome = texts(table, h);
    EXPECT_TRUE(outcome.completed);
    Mesh edited = mesh;
    Edit edit(edited, nullptr);
    op.apply(edit);
    edit.commit();
    EXPECT_EQ(triangles_of(table), sorted(test::polygons_of(edited)));
    EXPECT_LT(glm::distance(table.positions[to.index], edited.position(to)), 1e-12);
    expect_sound(table);
    ++compared;
  }
  return compared;
}

TEST(texts_operators, equal_the_kernel_on_closed_triangles) {
  const Mesh torus = test::make_mesh(test::torus_grid(5, 6));
  EXPECT_EQ(compare_on_every_edge<CollapseEdge>(octahedron(), source_collapse), 24u);
  EXPECT_EQ(compare_on_every_edge<CollapseEdge>(torus, source_collapse), 180u);
  EXPECT_GT(compare_on_every_edge<SwapEdge>(octahedron(), source_swap), 0u);
  EXPECT_EQ(compare_on_every_edge<SwapEdge>(torus, source_swap), 180u);
}

TEST(texts_operators, boundary_edge_has_no_pair_to_follow) {
  const HalfedgeTable whole = inner_halfedges(test::make_mesh({{0, 1, 2}, {2, 1, 3}}));
  for (const auto texts : {source_collapse, source_swap}) {
    HalfedgeTable table = whole;
    const SourceOutcome outcome = texts(table, 0);
    EXPECT_FALSE(outcome.completed);
    EXPECT_TRUE(outcome.pair_of_edge_missing);
    EXPECT_FALSE(outcome.changed_before);
    EXPECT_EQ(table, whole);
    EXPECT_NE(outcome.sentence.en.find("the edge itself"), std::string::npos);
    EXPECT_NE(outcome.sentence.en.find("nothing has been changed"), std::string::npos);
    EXPECT_NE(outcome.sentence.ja.find("何も変わっていません"), std::string::npos);
    // The listing's constructor sets vertex alone, and no pair is found at a boundary.
    EXPECT_NE(outcome.sentence.en.find("never set"), std::string::npos);
    EXPECT_EQ(outcome.sentence.en.find("null"), std::string::npos);
    EXPECT_NE(outcome.sentence.ja.find("値は不定"), std::string::npos);
    EXPECT_EQ(outcome.sentence.ja.find("NULL"), std::string::npos);
  }
}

TEST(texts_operators, inner_edge_beside_the_boundary_is_left_half_done) {
  const HalfedgeTable whole = inner_halfedges(test::make_mesh({{0, 1, 2}, {2, 1, 3}}));
  for (const auto texts : {source_collapse, source_swap}) {
    HalfedgeTable table = whole;
    const SourceOutcome outcome = texts(table, 1);
    EXPECT_FALSE(outcome.completed);
    EXPECT_FALSE(outcome.pair_of_edge_missing);
    EXPECT_TRUE(outcome.changed_before);
    EXPECT_FALSE(table == whole);
    EXPECT_NE(outcome.sentence.en.find("a neighbouring edge"), std::string::npos);
    EXPECT_NE(outcome.sentence.en.find("changed in part"), std::string::npos);
  }
}

// One missing neighbour is enough, wherever it is.
TEST(texts_operators, one_boundary_side_is_enough) {
  Mesh closed = octahedron();
  test::Polygons faces = test::polygons_of(closed);
  faces.erase(faces.begin());  // the triangle 0 1 2
  const HalfedgeTable whole = inner_halfedges(test::make_mesh(faces));
  std::size_t stopped = 0, completed = 0;
  for (std::uint32_t h = 0; h < whole.halfedges.size(); ++h) {
    if (whole.pair(h) == no_index) continue;
    HalfedgeTable table = whole;
    const bool open = whole.pair(whole.next(h)) == no_index || whole.pair(whole.prev(h)) == no_index ||
                      whole.pair(whole.next(whole.pair(h))) == no_index ||
                      whole.pair(whole.prev(whole.pair(h))) == no_index;
    const SourceOutcome outcome = source_swap(table, h);
    EXPECT_EQ(outcome.completed, !open);
    EXPECT_EQ(outcome.changed_before, open);
    ++(outcome.completed ? completed : stopped);
  }
  EXPECT_GT(stopped, 0u);
  EXPECT_GT(completed, 0u);
}

TEST(texts_operators, reports_both_places_for_both) {
  const std::vector<SourceReport> reports = sources_on_boundaries();
  ASSERT_EQ(reports.size(), 4u);
  for (const SourceReport& report : reports) {
    EXPECT_FALSE(report.outcome.completed);
    EXPECT_EQ(report.outcome.pair_of_edge_missing, report.place == "boundary_edge");
    EXPECT_EQ(report.outcome.changed_before, report.place == "beside_boundary");
    const bool on_edge = report.place == "boundary_edge", collapses = report.operation == "collapse";
    EXPECT_EQ(report.what.en,
              std::string(report.operation) + (on_edge ? " on a boundary edge" : " beside the boundary"));
    EXPECT_EQ(report.what.ja,
              std::string(collapses ? "稜線削除" : "稜線交換") + (on_edge ? "（境界の稜線）" : "（境界の隣）"));
  }
}

}  // namespace
}  // namespace ryosen::forms
