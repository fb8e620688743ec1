#include "core/mesh/copies.h"

#include <gtest/gtest.h>

#include "tests/support/core/random_ops.h"

namespace ryosen {
namespace {

TEST(copies, points_are_joined_where_there_is_a_sheet_between_them) {
  std::size_t joined = 0, pairs = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Mesh mesh = test::random_complex(seed);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
      for (std::uint32_t k = 0; k < mesh.vertex_slots(); ++k) {
        const Vertex a(i), b(k);
        if (!mesh.is_alive(a) || !mesh.is_alive(b) || same_point(mesh, a, b)) continue;
        ASSERT_EQ(are_joined(mesh, a, b), !sheets_between(mesh, a, b).empty())
            << "seed " << seed << " " << i << " " << k;
        joined += are_joined(mesh, a, b);
        ++pairs;
      }
  }
  EXPECT_GT(joined, 1000u);
  EXPECT_GT(pairs, 2 * joined);
}

}  // namespace
}  // namespace ryosen
