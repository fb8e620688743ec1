#include "ryosen/analysis/boundary_loops.h"

#include <gtest/gtest.h>

#include "ryosen/analysis/problem_sets.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// A sheet of n x n squares, and one triangle by itself.
Mesh sheet_and_triangle(std::uint32_t n) {
  Polygons faces;
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x, d = a + n + 1;
      faces.push_back({a, a + 1, d + 1});
      faces.push_back({a, d + 1, d});
    }
  const std::uint32_t first = (n + 1) * (n + 1);
  faces.push_back({first, first + 1, first + 2});
  return make_mesh(faces);
}

BoundaryLoopCount counted(const Mesh& mesh, const ProblemSets& sets) {
  Neighbourhood around(mesh);
  BoundaryLoopCount loops;
  loops.search(around, sets.of(ProblemKind::boundary_loop));
  return loops;
}

void take_out(Mesh& mesh, Journal& journal, Face f) {
  Edit edit(mesh, &journal);
  const Halfedge a = mesh.halfedge(f), b = mesh.next(a), c = mesh.next(b);
  for (Halfedge h : {a, b, c}) {
    edit.set_face(h, Face());
    edit.fresh(h);
    edit.set_halfedge(mesh.from(h), h);
  }
  edit.drop(f);
  edit.commit();
}

TEST(boundary_loop_count, is_that_of_named_shapes) {
  const auto count = [](const Polygons& faces) {
    const Mesh mesh = make_mesh(faces);
    return counted(mesh, ProblemSets(mesh)).count();
  };
  EXPECT_EQ(count(torus_grid(4, 4)), 0u);
  EXPECT_EQ(count(two_quads()), 1u);
  EXPECT_EQ(count(moebius_strip()), 1u);
  EXPECT_EQ(count(bow_tie()), 2u);
  EXPECT_EQ(count(fin()), 0u) << "chains that stop at a non-manifold edge are no loops";
}

// A fin with a hole beside it has both: a loop, and chains that are none.
TEST(boundary_loop_count, knows_of_chains_that_close_to_no_loop) {
  const auto has_open_chain = [](const Polygons& faces) {
    const Mesh mesh = make_mesh(faces);
    const ProblemSets sets(mesh);
    Neighbourhood around(mesh);
    const bool is_open = find_boundary_loops(around, sets.of(ProblemKind::boundary_loop)).has_open_chain;
    EXPECT_EQ(counted(mesh, sets).has_open_chain(), is_open);
    return is_open;
  };
  Polygons fin_and_triangle = fin();
  fin_and_triangle.push_back({10, 11, 12});
  for (const Polygons& faces :
       {torus_grid(4, 4), two_quads(), moebius_strip(), bow_tie(), closed_fan(5), cube(), two_tetrahedra_on_an_edge()})
    EXPECT_FALSE(has_open_chain(faces));
  EXPECT_TRUE(has_open_chain(fin()));
  EXPECT_TRUE(has_open_chain(fin_and_triangle));
}

TEST(boundary_loop_count, an_edit_at_the_border_does_not_look_at_other_loops) {
  Mesh mesh = sheet_and_triangle(8);
  Journal journal;
  ProblemSets sets(mesh);
  BoundaryLoopCount loops = counted(mesh, sets);
  EXPECT_EQ(loops.count(), 2u);
  for (const AnyOp& op : {AnyOp(CollapseEdge{find_halfedge(mesh, Vertex(3), Vertex(4))}),
                          AnyOp(SplitEdge{find_halfedge(mesh, Vertex(6), Vertex(7))})}) {
    Edit edit(mesh, &journal);
    apply(edit, op);
    edit.commit();
    sets.update(mesh, journal, journal.size() - 1);
    // A search would miss the triangle, whose edges are left out here.
    IndexSet part;
    sets.of(ProblemKind::boundary_loop).for_each([&](std::uint32_t e) {
      if (mesh.from(halfedge(Edge(e))).index < 81 || mesh.from(halfedge(Edge(e))).index >= 84) part.insert(e);
    });
    ASSERT_EQ(part.size() + 3, sets.count(ProblemKind::boundary_loop));
    const std::uint64_t before = loops.revision();
    Neighbourhood around(mesh);
    loops.update(around, part, sets.edges_asked());
    EXPECT_EQ(loops.count(), 2u);
    EXPECT_NE(loops.revision(), before) << "the loop has other edges";
  }
}

TEST(boundary_loop_count, an_edit_inside_changes_nothing) {
  Mesh mesh = sheet_and_triangle(8);
  Journal journal;
  ProblemSets sets(mesh);
  BoundaryLoopCount loops = counted(mesh, sets);
  const std::uint64_t before = loops.revision();
  {
    Edit edit(mesh, &journal);
    CollapseEdge{find_halfedge(mesh, Vertex(39), Vertex(40))}.apply(edit);
    edit.commit();
  }
  sets.update(mesh, journal, 0);
  Neighbourhood around(mesh);
  loops.update(around, sets.of(ProblemKind::boundary_loop), sets.edges_asked());
  EXPECT_EQ(loops.count(), 2u);
  EXPECT_EQ(loops.revision(), before);
}

TEST(boundary_loop_count, follows_holes_that_come_and_go) {
  Mesh mesh = sheet_and_triangle(8);
  Journal journal;
  ProblemSets sets(mesh);
  BoundaryLoopCount loops = counted(mesh, sets);
  const auto follow = [&](std::size_t transaction) {
    sets.update(mesh, journal, transaction);
    Neighbourhood around(mesh);
    loops.update(around, sets.of(ProblemKind::boundary_loop), sets.edges_asked());
    EXPECT_EQ(loops.count(), counted(mesh, ProblemSets(mesh)).count());
  };
  take_out(mesh, journal, mesh.face(find_halfedge(mesh, Vertex(20), Vertex(21))));
  follow(0);
  EXPECT_EQ(loops.count(), 3u);
  take_out(mesh, journal, mesh.face(find_halfedge(mesh, Vertex(58), Vertex(59))));
  follow(1);
  EXPECT_EQ(loops.count(), 4u);
  journal.undo(mesh);
  follow(1);
  EXPECT_EQ(loops.count(), 3u);
  journal.undo(mesh);
  follow(0);
  EXPECT_EQ(loops.count(), 2u);
}

}  // namespace
}  // namespace ryosen
