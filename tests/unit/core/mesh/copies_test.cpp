#include "core/mesh/copies.h"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

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

TEST(copies, many_fans_at_one_point_are_counted_in_no_time) {
  constexpr std::uint32_t fans = 20000;
  test::Polygons faces;
  for (std::uint32_t i = 0; i < fans; ++i) faces.push_back({0, 2 * i + 1, 2 * i + 2});
  const Mesh mesh = test::make_mesh(faces);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{2 * fans + 1, 3 * fans, fans, 0}));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

}  // namespace
}  // namespace ryosen
