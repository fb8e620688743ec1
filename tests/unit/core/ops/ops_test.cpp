#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/preview/remedy.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

AnyOp parse(const Mesh& mesh, std::string_view id, std::vector<std::string_view> arguments) {
  const ParsedOp parsed = parse_op(mesh, id, op_arguments(arguments));
  EXPECT_TRUE(parsed.op) << parsed.sentence.en;
  return *parsed.op;
}

// Applies a legal operator and expects sound columns, exact undo and exact redo.
void prove_applying(Mesh& mesh, const AnyOp& op) {
  ASSERT_TRUE(check(mesh, op).legal()) << text_of(check(mesh, op).reasons[0].rule).id;
  Journal journal;
  const MeshColumns before = mesh.columns();
  {
    Edit preview(mesh, &journal);
    apply(preview, op);
  }
  EXPECT_EQ(mesh.columns(), before);
  {
    Edit edit(mesh, &journal);
    apply(edit, op);
    edit.commit();
  }
  const auto broken = check_invariants(mesh);
  EXPECT_FALSE(broken) << broken->sentence;
  const MeshColumns after = mesh.columns();
  journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), before);
  journal.redo(mesh);
  EXPECT_EQ(mesh.columns(), after);
}

TEST(collapse, torus_edge_goes_with_its_triangles) {
  Mesh mesh = make_mesh(torus_grid(5, 5));
  const ElementCounts before = mesh.live();
  prove_applying(mesh, parse(mesh, "collapse", {"0-1"}));
  EXPECT_EQ(mesh.live(), (ElementCounts{before.vertices - 1, before.edges - 3, before.faces - 2}));
  EXPECT_FALSE(mesh.is_alive(Vertex(0)));
}

TEST(collapse, quads_lose_a_corner) {
  Mesh mesh = make_mesh(two_quads());
  prove_applying(mesh, parse(mesh, "collapse", {"2-3"}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 3}, {1, 0, 4, 5}}));
}

TEST(collapse, places) {
  for (const auto& [word, expected] : {std::pair{"start", 2.0}, {"end", 3.0}, {"mid", 2.5}, {"2.25,0,0", 2.25}}) {
    Mesh mesh = make_mesh(two_quads());
    prove_applying(mesh, parse(mesh, "collapse", {"2-3", word}));
    EXPECT_EQ(mesh.position(Vertex(3)).x, expected) << word;
  }
}

TEST(collapse, tetrahedron_is_refused) {
  const Mesh mesh = make_mesh(tetrahedron());
  EXPECT_TRUE(check(mesh, parse(mesh, "collapse", {"0-1"})).has(Rule::duplicate_face));
}

TEST(swap, two_triangles_change_diagonal_and_back) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}});
  const Polygons before = polygons_of(mesh);
  prove_applying(mesh, parse(mesh, "swap", {"0-1"}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 3, 2}, {1, 2, 3}}));
  prove_applying(mesh, parse(mesh, "swap", {"2-3", "back"}));
  EXPECT_EQ(polygons_of(mesh), before);
}

TEST(swap, turns_by_one_corner_between_quads) {
  Mesh mesh = make_mesh(two_quads());
  prove_applying(mesh, parse(mesh, "swap", {"0-1"}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 4, 2, 3}, {1, 2, 4, 5}}));
}

TEST(swap, boundary_and_existing_edge_are_refused) {
  const Mesh mesh = make_mesh(tetrahedron());
  EXPECT_TRUE(check(mesh, parse(mesh, "swap", {"0-1"})).has(Rule::edge_exists));
  const Mesh open = make_mesh(bow_tie());
  EXPECT_TRUE(check(open, parse(open, "swap", {"1-2"})).has(Rule::boundary));
}

// Face 2 is two loops joined by a bridge. Swapping 0-1 puts face 1 on the points 1 to 8.
TEST(swap, compares_points_with_a_face_that_has_a_bridge) {
  const Polygons two{{0, 1, 2}, {1, 0, 3, 4, 5, 6, 7, 8}};
  for (const bool is_equal : {false, true}) {
    Polygons faces = two;
    faces.push_back({3, 5, 7, 3, 6, 4, 8, 6});
    if (is_equal) faces[2] = {3, 5, 7, 3, 6, 1, 4, 8, 2, 6};
    IndexedMesh source = indexed(faces);
    source.bridged = {2};
    Mesh mesh = from_indexed(source);
    ASSERT_TRUE(mesh.has_rings(Face(2)));
    prove_applying(mesh, parse(mesh, "unite_ring", {"3", "6", "f2"}));
    ASSERT_FALSE(mesh.has_rings(Face(2)));
    const Verdict verdict = check(mesh, parse(mesh, "swap", {"0-1"}));
    EXPECT_EQ(verdict.has(Rule::duplicate_face), is_equal);
    EXPECT_EQ(verdict.legal(), !is_equal);
  }
}

TEST(split, cuts_triangles_and_lengthens_polygons) {
  Mesh triangles = make_mesh({{0, 1, 2}, {1, 0, 3}});
  prove_applying(triangles, parse(triangles, "split", {"0-1", "0.25"}));
  EXPECT_EQ(polygons_of(triangles), (Polygons{{0, 4, 2}, {4, 0, 3}, {4, 1, 2}, {1, 4, 3}}));
  EXPECT_EQ(triangles.position(Vertex(4)).x, 0.25);
  Mesh quads = make_mesh(two_quads());
  prove_applying(quads, parse(quads, "split", {"0-1"}));
  EXPECT_EQ(polygons_of(quads), (Polygons{{0, 6, 1, 2, 3}, {1, 6, 0, 4, 5}}));
}

// Text 003: the new vertex need not lie on the edge.
TEST(split, puts_the_vertex_where_it_is_told) {
  const Mesh before = make_mesh({{0, 1, 2}, {1, 0, 3}});
  Mesh mesh = before;
  const AnyOp op = parse(mesh, "split", {"0-1", "0.25,-1,2.5"});
  EXPECT_EQ(command_of(mesh, op), "split 0-1 0.25,-1,2.5");
  prove_applying(mesh, op);
  EXPECT_EQ(mesh.position(Vertex(4)), glm::dvec3(0.25, -1, 2.5));
  Mesh on_edge = before;
  prove_applying(on_edge, parse(before, "split", {"0-1"}));
  EXPECT_EQ(polygons_of(mesh), polygons_of(on_edge));
  const glm::dvec3 start = before.position(Vertex(0)), way = before.position(Vertex(1)) - start;
  const glm::dvec3 aside = glm::cross(way, glm::dvec3(3, 1, 2));
  for (const auto& [along, share] : {std::pair{9.0, 1.0}, {-9.0, 0.0}, {0.25, 0.25}}) {
    const glm::dvec3 p = start + along * way + aside;
    const std::string text = std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.z);
    EXPECT_NEAR(std::get<SplitEdge>(parse(before, "split", {"0-1", text})).blend(before), share, 1e-5) << text;
  }
  for (const std::string_view wrong : {"1,2", "a,b,c", "1,2,inf", "1,2,3,4"}) {
    const std::vector<std::string_view> words{"0-1", wrong};
    EXPECT_EQ(parse_op(before, "split", op_arguments(words)).error, NameError::malformed) << wrong;
  }
}

TEST(split, cuts_all_sheets_of_a_fin) {
  Mesh mesh = make_mesh(fin());
  const ElementCounts before = counts_on_points(mesh);
  prove_applying(mesh, parse(mesh, "split", {"0-1@f1"}));
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{before.vertices + 1, before.edges + 4, before.faces + 3}));
}

TEST(split, stays_finite_or_says_so) {
  IndexedMesh source = indexed({{0, 1, 2}});
  source.positions = {{-1e308, 0, 0}, {1e308, 0, 0}, {0, 1, 0}};
  Mesh mesh = from_indexed(std::move(source));
  prove_applying(mesh, parse(mesh, "split", {"0-1"}));
  EXPECT_EQ(mesh.position(Vertex(3)).x, 0);
  const std::vector<std::string_view> far{"0-2", "1e308"};
  EXPECT_EQ(parse_op(mesh, "split", op_arguments(far)).error, NameError::malformed);
}

TEST(split, warns_of_faces_that_turn_over) {
  const Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}});
  EXPECT_TRUE(warnings(mesh, parse(mesh, "split", {"0-1", "0.5"})).empty());
  EXPECT_EQ(warnings(mesh, parse(mesh, "split", {"0-1", "5"}))[0].rule, Rule::normal_turns);
  EXPECT_TRUE(warnings(mesh, parse(mesh, "split", {"0-1", "0.5,0,0.1"})).empty());
  EXPECT_FALSE(warnings(mesh, parse(mesh, "split", {"0-1", "0.5,99,0"})).empty());
}

TEST(orient, turns_a_flipped_face_and_leaves_a_seam_on_a_moebius_strip) {
  Mesh flipped = make_mesh({{0, 1, 2}, {1, 2, 3}, {2, 3, 4}});
  prove_applying(flipped, Orient{});
  EXPECT_FALSE(flipped.live().vertices != 5);
  EXPECT_TRUE(Orient{}.check(flipped).has(Rule::oriented));
  Mesh strip = make_mesh(moebius_strip());
  prove_applying(strip, Orient{});
  EXPECT_TRUE(Orient{}.check(strip).has(Rule::oriented));
}

// A click target from before an undo may name what the mesh does not have any more.
TEST(all_ops, speak_of_elements_that_are_not_there) {
  Mesh mesh = make_mesh(two_quads());
  {
    Edit edit(mesh, nullptr);
    apply(edit, Delete{Face(1)});
    edit.commit();
  }
  ASSERT_FALSE(mesh.is_alive(Face(1)));
  for (const std::uint32_t slot : {1u, 50u, no_index}) {
    const OpTarget target{Halfedge(slot == 1 ? mesh.halfedge_slots() - 1 : slot), 0.5, Vertex(slot == 1 ? 5 : slot),
                          Face(slot)};
    for (const OpInfo& info : all_ops()) {
      const AnyOp op = op_at(mesh, info.id, target);
      EXPECT_FALSE(command_of(mesh, op).empty());
      if (!is_tool(info) || (info.id == Triangulate::info.id && slot == no_index)) continue;  // speaks of no element
      EXPECT_TRUE(check(mesh, op).has(Rule::deleted)) << info.id << " " << slot;
      EXPECT_EQ(find_remedy(mesh, op), std::vector<std::string>()) << info.id;
    }
  }
  for (const std::string& line :
       {command_of(mesh, SeparateLoop{Halfedge(99), Halfedge(0)}), command_of(mesh, UniteRing{}),
        command_of(mesh, VertexSplit{Vertex(99), Halfedge(99), Halfedge()}),
        command_of(mesh, MakeEdge{Vertex(99), Vertex(0), Halfedge(99), Halfedge()})})
    EXPECT_FALSE(line.empty());
}

TEST(extrude, names_the_movement_that_it_takes) {
  const Mesh mesh = make_mesh(two_quads());
  EXPECT_EQ(command_of(mesh, Extrude{{Face(0)}, 2.0, glm::dvec3(0, 0, 1)}), "extrude f0 0,0,1");
}

}  // namespace
}  // namespace ryosen
