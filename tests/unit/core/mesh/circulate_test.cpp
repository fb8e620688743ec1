#include "ryosen/mesh/circulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/random_ops.h"

namespace ryosen {
namespace {

TEST(circulate, visits_the_ends_or_corners_of_an_element) {
  const Mesh mesh = test::random_complex(1);
  const auto vertices = [&](const Element& e) {
    std::vector<Vertex> found;
    for_each_vertex(mesh, e, [&](Vertex v) { found.push_back(v); });
    return found;
  };
  for (const Vertex v : live_vertices(mesh)) EXPECT_EQ(vertices(v), std::vector<Vertex>{v});
  for (const Edge e : live_edges(mesh)) {
    const auto [a, b] = ends(mesh, e);
    EXPECT_EQ(vertices(e), (std::vector<Vertex>{a, b}));
    EXPECT_EQ(vertices(halfedge(e, 1)), (std::vector<Vertex>{b, a}));
  }
  for (const Face f : live_faces(mesh)) {
    const auto corners = vertices_around(mesh, f);
    const std::vector<Vertex> found = vertices(f);
    ASSERT_EQ(found.size(), corner_count(mesh, f));
    EXPECT_TRUE(std::equal(corners.begin(), corners.end(), found.begin()));
  }
}

}  // namespace
}  // namespace ryosen
