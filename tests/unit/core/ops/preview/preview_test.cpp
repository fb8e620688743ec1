#include "ryosen/ops/preview/preview.h"

#include <gtest/gtest.h>

#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// A flat sheet of 6 x 6 squares with a spike at (2, 2).
Mesh sheet_with_spike() {
  IndexedMesh sheet;
  constexpr std::uint32_t n = 7;
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) sheet.positions.push_back({x, y, x == 2 && y == 2 ? 1.0 : 0.0});
  for (std::uint32_t y = 0; y + 1 < n; ++y)
    for (std::uint32_t x = 0; x + 1 < n; ++x)
      for (const std::uint32_t corner : {y * n + x, y * n + x + 1, (y + 1) * n + x + 1, (y + 1) * n + x}) {
        sheet.corners.push_back(corner);
        if (sheet.corners.size() % 4 == 0)
          sheet.face_offsets.push_back(static_cast<std::uint32_t>(sheet.corners.size()));
      }
  return from_indexed(std::move(sheet));
}

bool warns(const Preview& preview, Rule rule) {
  for (const Reason& warning : preview.warnings)
    if (warning.rule == rule) return true;
  return false;
}

TEST(preview, shows_the_result_and_leaves_mesh_and_redo_list_alone) {
  Mesh mesh = make_mesh(torus_grid(5, 5));
  Journal journal;
  {
    Edit edit(mesh, &journal);
    SplitEdge{find_halfedge(mesh, Vertex(0), Vertex(1))}.apply(edit);
    edit.commit();
  }
  journal.undo(mesh);
  const MeshColumns before = mesh.columns();
  const Preview shown = preview(mesh, journal, CollapseEdge{find_halfedge(mesh, Vertex(0), Vertex(1))});
  EXPECT_TRUE(shown.verdict.legal());
  EXPECT_EQ(shown.faces.size(), 8u);
  EXPECT_EQ(mesh.columns(), before);
  ASSERT_TRUE(journal.can_redo());
  journal.redo(mesh);
  EXPECT_EQ(mesh.live().vertices, 26u);
}

TEST(preview, warns_of_faces_that_would_cut_through_others) {
  Mesh mesh = sheet_with_spike();
  Journal journal;
  const Halfedge h = find_halfedge(mesh, Vertex(3 * 7 + 3), Vertex(3 * 7 + 4));
  EXPECT_FALSE(warns(preview(mesh, journal, CollapseEdge{h, CollapseEdge::Place::middle}), Rule::intersects));
  const CollapseEdge far{h, CollapseEdge::Place::point, {0.5, 0.5, 0.3}};
  EXPECT_TRUE(warns(preview(mesh, journal, far), Rule::intersects));
}

TEST(preview, costs_little_beside_a_vertex_of_many_faces) {
  // Visiting the hub once per neighbour would take minutes and gigabytes here.
  Mesh mesh = make_mesh(closed_fan(50000));
  Journal journal;
  EXPECT_TRUE(preview(mesh, journal, SplitEdge{find_halfedge(mesh, Vertex(1), Vertex(2))}).verdict.legal());
}

TEST(preview, warns_of_turned_and_degenerate_faces) {
  Mesh mesh = sheet_with_spike();
  Journal journal;
  const Halfedge h = find_halfedge(mesh, Vertex(3 * 7 + 4), Vertex(3 * 7 + 5));
  EXPECT_TRUE(
      warns(preview(mesh, journal, CollapseEdge{h, CollapseEdge::Place::point, {4.5, 6.5, 0}}), Rule::normal_turns));
  Mesh flat = make_mesh({{0, 1, 2}, {1, 0, 3}});
  const SplitEdge at_end{find_halfedge(flat, Vertex(0), Vertex(1)), 0};
  EXPECT_TRUE(warns(preview(flat, journal, at_end), Rule::degenerate));
}

TEST(preview, judges_whatever_number_of_faces_it_shows) {
  constexpr std::uint32_t rim = 3000;
  IndexedMesh fan;
  fan.positions.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < rim; ++i) fan.positions.emplace_back(1 + i % 2, i, 0);
  for (std::uint32_t i = 1; i < rim; ++i) {
    fan.corners.insert(fan.corners.end(), {0, i, i + 1});
    fan.face_offsets.push_back(3 * i);
  }
  Mesh mesh = from_indexed(fan);
  Journal journal;
  const Preview at_one_place = preview(mesh, journal, op_of(mesh, "move_vertex v0 1,300,0"));
  EXPECT_EQ(at_one_place.faces.size(), rim - 1);
  EXPECT_TRUE(warns(at_one_place, Rule::same_place));
  EXPECT_FALSE(warns(preview(mesh, journal, op_of(mesh, "move_vertex v0 0,0,0.5")), Rule::same_place));
}

TEST(triangles_cross, proper_crossings_only) {
  const std::array<glm::dvec3, 3> floor{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  EXPECT_TRUE(triangles_cross(floor, {{{1, 1, -1}, {1, 1, 1}, {1.5, 1, 1}}}));
  EXPECT_FALSE(triangles_cross(floor, {{{1, 1, 1}, {1, 2, 1}, {2, 1, 2}}}));
  EXPECT_FALSE(triangles_cross(floor, {{{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}}));
  EXPECT_FALSE(triangles_cross(floor, {{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}}));
  EXPECT_FALSE(triangles_cross(floor, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}));
}

}  // namespace
}  // namespace ryosen
