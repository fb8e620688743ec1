#include "render/hilbert_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "ryosen/base/handle.h"

namespace ryosen {
namespace {

std::vector<std::uint32_t> order_of(const std::vector<glm::vec3>& points) {
  DrawBox box;
  for (const glm::vec3& p : points) box.add(p);
  const auto order =
      hilbert_order(static_cast<std::uint32_t>(points.size()), box, [&](std::uint32_t first, std::span<glm::vec3> to) {
        std::copy_n(points.begin() + first, to.size(), to.begin());
      });
  return {order.begin(), order.end()};
}

TEST(hilbert_order, names_every_point_once) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 1000; ++i) points.push_back({float(i * 37 % 101), float(i * 53 % 97), float(i % 7)});
  std::vector<std::uint32_t> order = order_of(points);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
  EXPECT_EQ(order.size(), points.size());
}

// On a full grid a Hilbert curve only takes steps to a neighbour.
TEST(hilbert_order, steps_along_a_grid_are_short) {
  constexpr int side = 8;
  std::vector<glm::vec3> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      // The last cells reach to the end of the axes, so that each point has a cell of its own at the coarse levels.
      for (int z = 0; z < side; ++z) points.push_back(glm::vec3(x, y, z) * (1023.0f / side) + 60.0f);
    }
  }
  points.push_back(glm::vec3(0));
  points.push_back(glm::vec3(1023));
  const std::vector<std::uint32_t> order = order_of(points);
  std::vector<std::uint32_t> inner;
  for (const std::uint32_t i : order) {
    if (i < side * side * side) inner.push_back(i);
  }
  for (std::size_t i = 1; i < inner.size(); ++i) {
    ASSERT_NEAR(glm::length(points[inner[i]] - points[inner[i - 1]]), 1023.0f / side, 0.5f) << i;
  }
}

TEST(hilbert_order, equal_places_keep_their_order) {
  const std::vector<glm::vec3> points(5, glm::vec3(2, 3, 4));
  EXPECT_EQ(order_of(points), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(order_of({}).empty());
}

// So many that several threads share them.
TEST(hilbert_order, of_many_points_is_that_of_their_cells_and_stable) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 250000; ++i) points.push_back({float(i * 37 % 101), float(i * 53 % 97), float(i % 7)});
  const std::vector<std::uint32_t> order = order_of(points);
  std::vector<std::uint32_t> place(order.size(), no_index);
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  constexpr int period = 101 * 97 * 7;  // points so far apart in the list are equal
  for (std::size_t i = 0; i + period < points.size(); ++i) ASSERT_LT(place[i], place[i + period]);
  EXPECT_EQ(std::count(place.begin(), place.end(), no_index), 0);
}

}  // namespace
}  // namespace ryosen
