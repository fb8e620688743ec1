// Meshes that are added to others.
#include "ryosen/mesh/append_mesh.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/invariants.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

TEST(append_mesh, makes_the_faces_of_both_in_their_order) {
  Mesh mesh = make_mesh(two_quads());
  const Mesh part = make_mesh(closed_fan(5), 8);  // two points are isolated
  Polygons expected = polygons_of(mesh);
  for (std::vector<std::uint32_t> face : polygons_of(part)) {
    for (std::uint32_t& corner : face) corner += mesh.vertex_slots();
    expected.push_back(face);
  }
  const std::uint32_t vertices = mesh.vertex_slots(), edges = mesh.live().edges;
  Edit edit(mesh, nullptr);
  append_mesh(edit, part);
  edit.commit();
  EXPECT_EQ(polygons_of(mesh), expected);
  EXPECT_EQ(mesh.live().vertices, vertices + 8);
  EXPECT_EQ(mesh.live().edges, edges + part.live().edges);
  for (std::uint32_t i = 0; i < part.vertex_slots(); ++i) {
    EXPECT_EQ(mesh.position(Vertex(vertices + i)), part.position(Vertex(i)));
    EXPECT_EQ(mesh.is_isolated(Vertex(vertices + i)), part.is_isolated(Vertex(i)));
  }
  const auto broken = check_invariants(mesh);
  EXPECT_FALSE(broken) << broken->sentence;
}

TEST(append_mesh, of_nothing_to_nothing_is_nothing) {
  Mesh mesh;
  Edit edit(mesh, nullptr);
  append_mesh(edit, Mesh());
  edit.commit();
  EXPECT_EQ(mesh.columns(), MeshColumns());
}

}  // namespace
}  // namespace ryosen::test
