#include "ryosen/scene/pick/hidden_elements.h"

#include <gtest/gtest.h>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {
namespace {

// Three triangles on the edge 0-1: a sheet for each.
Mesh book() {
  IndexedMesh list;
  list.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  list.face_offsets = {0, 3, 6, 9};
  list.corners = {0, 1, 2, 0, 1, 3, 0, 1, 4};
  return from_indexed(std::move(list));
}

TEST(hidden_elements, a_point_or_edge_is_hidden_when_all_its_copies_are) {
  const Mesh mesh = book();
  HiddenElements hidden;
  const auto spine = [&](Face f) {
    return edge(find_halfedge(mesh, mesh.from(mesh.halfedge(f)), mesh.to(mesh.halfedge(f))));
  };
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_FALSE(hidden.hides(mesh, Vertex(0))) << i;
    EXPECT_FALSE(hidden.hides(mesh, spine(Face(0)))) << i;
    const Element page = Face(i);
    EXPECT_EQ(hidden.hide(mesh, {&page, 1}).faces, std::vector<Face>{Face(i)});
    EXPECT_TRUE(hidden.hide(mesh, {&page, 1}).empty()) << "it is so already";
  }
  EXPECT_TRUE(hidden.hides(mesh, Vertex(0)));
  EXPECT_TRUE(hidden.hides(mesh, spine(Face(0))));
  EXPECT_EQ(hidden.show_all().faces.size(), 3u);
  const Element edge_of_one = spine(Face(1));
  EXPECT_EQ(hidden.hide(mesh, {&edge_of_one, 1}).faces.size(), 3u) << "it stands for all sheets";
}

TEST(hidden_elements, isolating_says_what_came_and_what_went) {
  const Mesh mesh = book();
  HiddenElements hidden;
  const Element pages[] = {Face(0), Face(1), Face(2)};
  hidden.hide(mesh, {pages, 1});
  const HiddenElements::Parts changed = hidden.isolate(mesh, {pages, 2});
  EXPECT_EQ(changed.faces, (std::vector<Face>{Face(2), Face(0)}));
  EXPECT_EQ(hidden.faces().to_vector(), std::vector<std::uint32_t>{2});
}

}  // namespace
}  // namespace ryosen
