
#include <gtest/gtest.h>

#include "ryosen/ops/preview/preview.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;
using Places = std::vector<glm::dvec3>;

// The ids of the warnings of a legal line, separated by blanks.
std::string doubts_about(Mesh mesh, const std::string& line) {
  Journal journal;
  const AnyOp op = op_of(mesh, line);
  const MeshColumns before = mesh.columns();
  const Preview shown = preview(mesh, journal, op);
  EXPECT_TRUE(shown.verdict.legal()) << line;
  EXPECT_EQ(mesh.columns(), before) << line;
  std::string ids;
  for (const Reason& reason : shown.warnings) {
    EXPECT_FALSE(reason.witnesses.empty()) << line;
    ids += (ids.empty() ? "" : " ") + std::string(text_of(reason.rule).id);
  }
  return ids;
}

Mesh mesh_at(const Places& places, const Polygons& faces, const std::vector<std::uint32_t>& bridged = {}) {
  IndexedMesh source = indexed(faces, places.size());
  source.positions = places;
  source.bridged = bridged;
  return from_indexed(std::move(source));
}

// A plate of 9 by 9 with a square hole from 3 to 6, read as a ring.
Mesh plate_with_hole() {
  return mesh_at({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}},
                 {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}}, {0});
}
Mesh arrow() {  // its corner 2 lies within
  return mesh_at({{0, 0, 0}, {9, 0, 0}, {1, 1, 0}, {0, 9, 0}}, {{0, 1, 2, 3}});
}
Mesh square() { return mesh_at({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{0, 1, 2, 3}}); }

TEST(doubts, an_edge_across_a_hole) {
  ASSERT_EQ(plate_with_hole().live().rings, 1u);
  EXPECT_EQ(doubts_about(plate_with_hole(), "separate_loop v0 v2"), "leaves_face");
  EXPECT_EQ(doubts_about(plate_with_hole(), "separate_loop v4 v6"), "normal_turns") << "through the hole";
  EXPECT_EQ(doubts_about(plate_with_hole(), "unite_ring v0 v4"), "");
  EXPECT_EQ(doubts_about(plate_with_hole(), "unite_ring v0 v6"), "leaves_face");
  EXPECT_EQ(doubts_about(plate_with_hole(), "unite_ring v0 v5"), "");
}

TEST(doubts, an_edge_outside_of_its_face) {
  EXPECT_EQ(doubts_about(square(), "separate_loop v0 v2"), "");
  EXPECT_EQ(doubts_about(arrow(), "separate_loop v0 v2"), "");
  EXPECT_NE(doubts_about(arrow(), "separate_loop v1 v3"), "");
  // A comb: from tooth to tooth over the gap, and through a tooth.
  const Mesh comb = mesh_at({{0, 0, 0},
                             {5, 0, 0},
                             {5, 4, 0},
                             {4, 4, 0},
                             {4, 1, 0},
                             {3, 1, 0},
                             {3, 3, 0},
                             {2, 3, 0},
                             {2, 1, 0},
                             {1, 1, 0},
                             {1, 4, 0},
                             {0, 4, 0}},
                            {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
  EXPECT_NE(doubts_about(comb, "separate_loop v3 v6"), "");
  EXPECT_NE(doubts_about(comb, "separate_loop v4 v9"), "");
  EXPECT_NE(doubts_about(comb, "separate_loop v0 v2"), "");
  EXPECT_EQ(doubts_about(comb, "separate_loop v0 v4"), "");
}

TEST(doubts, a_new_vertex_outside_of_its_edge_or_on_an_end) {
  for (const char* op : {"split", "separate_edge"}) {
    const std::string line = std::string(op) + " 0-1 ";
    EXPECT_EQ(doubts_about(square(), line + "0.5"), "");
    EXPECT_EQ(doubts_about(square(), line + "1.5"), "outside_edge") << op;
    EXPECT_EQ(doubts_about(square(), line + "-0.25"), "outside_edge") << op;
    EXPECT_EQ(doubts_about(square(), line + "0"), "same_place") << op;
    EXPECT_EQ(doubts_about(square(), line + "1"), "same_place") << op;
  }
  Mesh wire = mesh_at({{0, 0, 0}, {1, 0, 0}}, {});
  Edit edit(wire, nullptr);
  ryosen::apply(edit, op_of(wire, "make_edge v0 v1"));
  edit.commit();
  EXPECT_EQ(doubts_about(wire, "split 0-1 2"), "outside_edge");
  EXPECT_EQ(doubts_about(wire, "split 0-1 0"), "same_place");
}

TEST(doubts, two_vertices_at_one_place) {
  EXPECT_EQ(doubts_about(square(), "make_vertex 9,9,0"), "same_place");
  EXPECT_EQ(doubts_about(square(), "make_vertex 9,9,1"), "");
  EXPECT_EQ(doubts_about(square(), "move_vertex v0 9,0,0"), "same_place");
  const Mesh beside = mesh_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}});
  EXPECT_EQ(doubts_about(beside, "move_vertex v3 1,0,0"), "same_place");
  EXPECT_EQ(doubts_about(beside, "move_vertex v3 5,5,6"), "");
  const Mesh twice = mesh_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{0, 1, 2}});
  EXPECT_EQ(doubts_about(twice, "move_vertex v3 0,0,0"), "") << "what was so is no news";
}

TEST(doubts, a_face_whose_sides_cross) {
  const Mesh points = mesh_at({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 8, 0}}, {});
  EXPECT_EQ(doubts_about(points, "make_face v0 v1 v2 v3"), "");
  EXPECT_EQ(doubts_about(points, "make_face v0 v1 v3 v2"), "leaves_face");
  EXPECT_NE(doubts_about(square(), "move_vertex v0 12,6,0").find("leaves_face"), std::string::npos);
  EXPECT_EQ(doubts_about(square(), "move_vertex v0 1,1,0"), "");
}

TEST(doubts, faces_that_lie_otherwise_after_they_are_joined) {
  // Two squares folded onto each other, one a little larger.
  const Mesh fold =
      mesh_at({{0, 0, 0}, {0, 9, 0}, {9, 9, 0}, {9, 0, 0}, {5, 9, 1}, {5, 0, 1}}, {{0, 3, 2, 1}, {0, 1, 4, 5}});
  EXPECT_NE(doubts_about(fold, "unite_loop 0-1"), "");
  // Without its tip the kite is a line.
  const Mesh flat = mesh_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
  EXPECT_EQ(doubts_about(flat, "unite_edge v3"), "degenerate");
  EXPECT_EQ(doubts_about(flat, "unite_edge v1"), "");
  // A vertex welded to one on the other side of its triangle.
  const Mesh apart =
      mesh_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {-5, -5, 0}, {-5, -6, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_NE(doubts_about(apart, "weld v3 v0").find("normal_turns"), std::string::npos);
}

}  // namespace
}  // namespace ryosen
