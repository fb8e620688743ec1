#include "ryosen/mesh/live_elements.h"

#include <gtest/gtest.h>

#include <vector>

#include "ryosen/mesh/edit.h"
#include "ryosen/ops/delete.h"
#include "ryosen/ops/rules/sheets.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

template <class Handle, class Range>
void expect_all_live(const Mesh& mesh, const Range& range, std::uint32_t slots, std::uint32_t first = 0) {
  std::vector<Handle> expected, found;
  for (std::uint32_t i = first; i < slots; ++i)
    if (mesh.is_alive(Handle(i))) expected.emplace_back(i);
  for (const Handle element : range) found.push_back(element);
  EXPECT_EQ(found, expected);
}

void expect_live_elements(const Mesh& mesh) {
  expect_all_live<Vertex>(mesh, live_vertices(mesh), mesh.vertex_slots());
  expect_all_live<Edge>(mesh, live_edges(mesh), mesh.edge_slots());
  expect_all_live<Face>(mesh, live_faces(mesh), mesh.face_slots());
  expect_all_live<Halfedge>(mesh, live_halfedges(mesh), mesh.halfedge_slots());
  for (std::uint32_t first = 0; first <= mesh.face_slots() + 1; ++first)
    expect_all_live<Face>(mesh, live_faces(mesh, Face(first)), mesh.face_slots(), first);
}

void remove(Mesh& mesh, std::vector<Face> faces) {
  Edit edit(mesh, nullptr);
  Sheets sheets(edit);
  Deletion deletion;
  deletion.faces = std::move(faces);
  delete_elements(edit, sheets, deletion);
}

TEST(live_elements, leave_out_deleted_slots) {
  expect_live_elements(Mesh());
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Mesh mesh = test::random_complex(seed);
    expect_live_elements(mesh);
    std::vector<Face> some, all;
    for (const Face f : live_faces(mesh)) {
      all.push_back(f);
      if (f.index % 3 != 1) some.push_back(f);
    }
    remove(mesh, some);
    expect_live_elements(mesh);
    std::erase_if(all, [&](Face f) { return !mesh.is_alive(f); });
    remove(mesh, all);
    expect_live_elements(mesh);
    EXPECT_TRUE(live_faces(mesh).begin() == live_faces(mesh).end());
  }
}

TEST(live_elements, follow_edits_during_the_walk) {
  Mesh mesh;
  Edit edit(mesh, nullptr);
  for (int i = 0; i < 4; ++i) edit.fresh(edit.add_vertex({i, 0, 0}));
  std::vector<std::uint32_t> met;
  for (const Vertex v : live_vertices(mesh)) {
    met.push_back(v.index);
    if (v.index == 0) edit.drop(Vertex(1));
    if (v.index == 2) edit.drop(v);
    if (v.index == 3) edit.fresh(edit.add_vertex({9, 0, 0}));
  }
  EXPECT_EQ(met, (std::vector<std::uint32_t>{0, 2, 3, 4}));
}

}  // namespace
}  // namespace ryosen
