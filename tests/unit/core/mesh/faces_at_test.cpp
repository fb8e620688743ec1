#include "ryosen/mesh/faces_at.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/random_ops.h"

namespace ryosen {
namespace {

// The faces of the corners at a point, ascending.
std::vector<Face> faces_of_corners(const Mesh& mesh, Vertex v) {
  std::vector<Face> faces;
  for (const Face f : live_faces(mesh))
    for (const Vertex corner : vertices_around(mesh, f))
      if (same_point(mesh, corner, v)) faces.push_back(f);
  return faces;
}

TEST(faces_at, are_those_with_a_corner_at_the_point) {
  std::size_t with_copies = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Mesh mesh = test::random_complex(seed);
    for (const Vertex v : live_vertices(mesh)) {
      std::vector<Face> found;
      for_each_face_at(mesh, v, [&](Face f) { found.push_back(f); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, faces_of_corners(mesh, v)) << "seed " << seed << " v" << v.index;
      for (const Face f : found) ASSERT_TRUE(any_of_faces_at(mesh, v, [&](Face other) { return other == f; }));
      ASSERT_FALSE(any_of_faces_at(mesh, v, [](Face f) { return f.is_none(); }));
      ASSERT_EQ(any_of_faces_at(mesh, v, [](Face) { return true; }), !found.empty());
      with_copies += has_copies(mesh, v);
    }
  }
  EXPECT_GT(with_copies, 0u);
}

}  // namespace
}  // namespace ryosen
