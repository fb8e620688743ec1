// Descents tell where the elements of a mesh come from, through edits and through columns that replace all others.
#include "ryosen/mesh/descent.h"

#include <gtest/gtest.h>

#include <functional>

#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/split_edge.h"
#include "ryosen/ops/triangulate.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

TEST(descent, parts_have_the_origin_of_what_was_divided) {
  Mesh mesh = make_mesh(two_quads());
  const Mesh before = mesh;
  Descent descent(mesh);
  {
    Edit edit(mesh, nullptr, &descent);
    Triangulate{Face(1)}.apply(edit);
    edit.commit();
  }
  ASSERT_EQ(mesh.face_slots(), 3u);
  EXPECT_EQ(descent.origin(Face(0)), Face(0));
  EXPECT_EQ(descent.origin(Face(1)), Face(1));
  EXPECT_EQ(descent.origin(Face(2)), Face(1));
  EXPECT_EQ(descent.origin(Edge(before.edge_slots())), Edge()) << "the diagonal is new";
  EXPECT_EQ(descent.untold(before.columns(), mesh.columns()), std::nullopt);
  const Element asked[] = {Face(1), Edge(0), Vertex(2)};
  EXPECT_EQ(descended(mesh, descent, asked), (std::vector<Element>{Face(1), Face(2), Edge(0), Vertex(2)}));
}

TEST(descent, goes_through_several_edits) {
  Mesh mesh = make_mesh(two_quads());
  Descent descent(mesh);
  Edit edit(mesh, nullptr, &descent);
  SplitEdge{Halfedge(0), 0.5}.apply(edit);
  const Edge half(mesh.edge_slots() - 1);
  EXPECT_EQ(descent.origin(half), Edge(0));
  SplitEdge{halfedge(half), 0.5}.apply(edit);
  EXPECT_EQ(descent.origin(Edge(mesh.edge_slots() - 1)), Edge(0)) << "a part of a part";
  descent.lose(half);
  EXPECT_EQ(descent.origin(half), Edge());
  EXPECT_EQ(descent.origin(Edge(0)), Edge(0));
}

TEST(descent, an_edge_that_is_lost_is_new_and_stays_so) {
  Mesh mesh = make_mesh(two_quads());
  Descent descent(mesh);
  descent.lose(Edge(2));
  EXPECT_EQ(descent.untold(mesh.columns(), mesh.columns()), std::nullopt);
  Edit edit(mesh, nullptr, &descent);
  edit.derive(Edge(2), Edge(0), Derivation::copies);
  EXPECT_EQ(descent.origin(Edge(2)), Edge());
}

TEST(descent, what_stays_keeps_its_origin_where_others_are_united_with_it) {
  Mesh mesh = make_mesh(two_quads());
  const Mesh before = mesh;
  Descent descent(mesh);
  Edit edit(mesh, nullptr, &descent);
  Triangulate{}.apply(edit);
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index) {
    if (const CollapseEdge op{h}; op.check(mesh).legal()) {
      op.apply(edit);
      break;
    }
  }
  ASSERT_EQ(mesh.live().vertices, 5u);
  for (const Face f : live_faces(mesh))
    if (f.index < before.face_slots()) {
      EXPECT_EQ(descent.origin(f), f);
    }
  for (const Edge e : live_edges(mesh))
    if (e.index < before.edge_slots()) {
      EXPECT_EQ(descent.origin(e), e);
    }
  EXPECT_EQ(descent.untold(before.columns(), mesh.columns()), std::nullopt) << "one vertex was united with another";
}

struct SourceLists {
  SourceList vertices, edges, corners, faces;
};

// The sentence on a replacement of two quads by themselves, with the elements that `further` makes.
std::optional<std::string> said(
    const std::function<void(SourceLists&)>& change,
    const std::function<void(MeshColumns&)>& further = [](MeshColumns&) {}) {
  const Mesh before = make_mesh(two_quads());
  MeshColumns after = before.columns();
  further(after);
  const auto more = [&](std::size_t count, std::size_t old) { return SourceList::kept(old, count - old); };
  SourceLists lists{
      more(after.vertex_halfedge.size(), before.vertex_slots()), more(after.halfedges.size() / 2, before.edge_slots()),
      more(after.halfedges.size(), before.halfedge_slots()), more(after.face_halfedge.size(), before.face_slots())};
  change(lists);
  Descent descent(before);
  descent.follow(ElementKind::vertex, lists.vertices);
  descent.follow(ElementKind::edge, lists.edges);
  descent.follow(ElementKind::corner, lists.corners);
  descent.follow(ElementKind::face, lists.faces);
  return descent.untold(before.columns(), after);
}

void add_vertex(MeshColumns& columns) {
  columns.vertex_halfedge.push_back(Halfedge());
  columns.positions.emplace_back(0);
}

TEST(descent, of_new_elements_of_a_replacement_is_asked) {
  EXPECT_EQ(said([](SourceLists&) {}), std::nullopt);
  EXPECT_EQ(said([](SourceLists&) {}, add_vertex), "v6 was created without saying what its values come from");
  EXPECT_EQ(said([](SourceLists& lists) { lists.vertices.fresh(6); }, add_vertex), std::nullopt);
  EXPECT_EQ(said([](SourceLists& lists) { lists.vertices.part(6, 0, 1); }, add_vertex), std::nullopt);
  EXPECT_EQ(said(
                [](SourceLists& lists) {
                  const std::uint32_t both[] = {0, 1};
                  const double weights[] = {0.5, 0.5};
                  lists.vertices.between(6, both, weights);
                },
                add_vertex),
            std::nullopt);
  EXPECT_EQ(said([](SourceLists& lists) { lists.corners = SourceList(lists.corners.size()); }),
            "corner h0 was created without saying what its values come from");
}

TEST(descent, of_removed_elements_of_a_replacement_is_asked) {
  const auto kill = [](MeshColumns& columns) { columns.face_halfedge[1] = dead_halfedge; };
  EXPECT_EQ(said([](SourceLists&) {}, kill), "f1 was removed without saying what it is united with");
  EXPECT_EQ(said([](SourceLists& lists) { lists.faces.drop(1); }, kill), std::nullopt);
  EXPECT_EQ(said(
                [](SourceLists& lists) {
                  const std::uint32_t both[] = {0, 1};
                  const double weights[] = {0.5, 0.5};
                  lists.faces.between(0, both, weights);
                  lists.faces.drop(0);
                },
                kill),
            "f1 was removed without saying what it is united with")
      << "what lies between two ends neither";
  EXPECT_EQ(said([](SourceLists& lists) { lists.faces.keep(0, 1), lists.faces.drop(0); }, kill), std::nullopt);
  EXPECT_EQ(said([](SourceLists& lists) { lists.edges.keep(0, 1); }),
            "e0 was removed without saying what it is united with")
      << "another took its place";
}

TEST(descent, one_that_records_nothing_is_told_nothing) {
  Mesh mesh = make_mesh(two_quads());
  Descent descent;
  Edit edit(mesh, nullptr, &descent);
  Triangulate{}.apply(edit);
  EXPECT_FALSE(descent.is_recording());
  descent.lose(Edge(0));
  EXPECT_EQ(descent.origin(Face(0)), Face());
}

#ifdef RYOSEN_PROVENANCE
TEST(descent, an_edit_that_replaces_everything_is_asked_at_its_end) {
  Mesh mesh = make_mesh(two_quads());
  MeshColumns columns = mesh.columns();
  add_vertex(columns);
  Edit edit(mesh, nullptr);
  Descent descent = edit.new_descent();
  edit.replace(columns, descent);
  EXPECT_EQ(edit.untold(), "v6 was created without saying what its values come from");
}

TEST(descent, another_mesh_owes_no_sources) {
  Mesh mesh = make_mesh(two_quads());
  MeshColumns columns = mesh.columns();
  add_vertex(columns);
  Edit edit(mesh, nullptr);
  edit.replace_by_other(columns);
  EXPECT_EQ(edit.untold(), std::nullopt);
}
#endif

TEST(descent, another_mesh_is_not_followed) {
  Mesh mesh = make_mesh(two_quads());
  Descent descent(mesh);
  Edit edit(mesh, nullptr, &descent);
  edit.replace_by_other(mesh.columns());
  edit.commit();
  EXPECT_FALSE(descent.is_recording());
}

}  // namespace
}  // namespace ryosen::test
