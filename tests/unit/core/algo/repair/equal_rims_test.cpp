#include "ryosen/algo/repair/rims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/core/open_shapes.h"

namespace ryosen::test {
namespace {

using Rim = std::vector<glm::dvec3>;

// One without any symmetry.
Rim odd_rim(std::uint32_t corners) {
  Rim rim;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners, radius = 1 + 0.3 * std::sin(1.7 * i * i);
    rim.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.2 * std::cos(2.3 * i)});
  }
  return rim;
}

Rim turned_rim(Rim rim) {
  IndexedMesh list;
  list.positions = std::move(rim);
  return turned(std::move(list)).positions;
}

std::optional<EqualRim> match(const Rim& first, const Rim& second) {
  return find_equal_rims(std::vector<Rim>{first, second}, 1e-14)[1];
}

TEST(equal_rims, are_found_when_turned_and_begun_elsewhere) {
  for (const std::uint32_t corners : {3u, 4u, 5u, 12u, 49u}) {
    const Rim rim = odd_rim(corners);
    for (const std::uint32_t first : {0u, 1u, corners - 1}) {
      Rim other = turned_rim(rim);
      std::rotate(other.begin(), other.begin() + first, other.end());
      const auto equal = match(rim, other);
      ASSERT_TRUE(equal) << corners;
      EXPECT_EQ(equal->as, 0u);
      EXPECT_FALSE(equal->is_mirrored);
      for (std::uint32_t i = 0; i < corners; ++i) EXPECT_EQ(equal->corner_of(i, corners), (i + first) % corners);
    }
  }
}

TEST(equal_rims, are_found_when_mirrored) {
  const Rim rim = odd_rim(11);
  Rim other = rim;
  for (glm::dvec3& p : other) p.z = 5 - p.z;
  std::reverse(other.begin(), other.end());
  const auto equal = match(rim, turned_rim(other));
  ASSERT_TRUE(equal);
  EXPECT_TRUE(equal->is_mirrored);
  for (std::uint32_t i = 0; i < 11; ++i) EXPECT_EQ(equal->corner_of(i, 11), 10 - i);
}

TEST(equal_rims, are_not_those_that_differ) {
  const Rim rim = odd_rim(11);
  EXPECT_FALSE(match(rim, odd_rim(12)));
  Rim larger = rim, bent = rim, backwards = rim;
  for (glm::dvec3& p : larger) p *= 1.001;
  bent[4].z += 0.001;
  std::reverse(backwards.begin(), backwards.end());
  for (glm::dvec3& p : backwards) p.x += 0.1 * p.y;
  EXPECT_FALSE(match(rim, larger));
  EXPECT_FALSE(match(rim, bent));
  EXPECT_FALSE(match(rim, backwards));
  EXPECT_FALSE(match({}, {}));
  const Rim line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  EXPECT_FALSE(match(line, line));
}

TEST(equal_rims, among_many_are_told_by_the_first_of_each_kind) {
  std::vector<Rim> rims;
  for (std::uint32_t i = 0; i < 60; ++i) {
    Rim rim = i % 3 == 0 ? odd_rim(9) : i % 3 == 1 ? odd_rim(10) : turned_rim(odd_rim(9));
    for (glm::dvec3& p : rim) p = p * (i % 2 == 0 ? 1.0 : 2.0) + glm::dvec3(3.0 * i, 0, 0);
    rims.push_back(std::move(rim));
  }
  const auto found = find_equal_rims(rims, 1e-12);
  for (std::uint32_t i = 0; i < 60; ++i) {
    const bool is_first = i < 2 || i == 3 || i == 4;
    EXPECT_EQ(found[i].has_value(), !is_first) << i;
    if (found[i]) {
      EXPECT_EQ(rims[found[i]->as].size(), rims[i].size());
    }
  }
}

TEST(equal_rims, get_the_same_patch_in_their_own_place) {
  const Rim rim = odd_rim(6);
  Rim other = rim;
  for (glm::dvec3& p : other) p.x = 9 - p.x;
  std::reverse(other.begin(), other.end());
  HolePatch patch;
  patch.corners = 6;
  patch.places = rim;
  patch.places.push_back({0.1, 0.2, 0.7});
  for (std::uint32_t i = 0; i < 6; ++i) patch.triangles.push_back({i, (i + 1) % 6, 6});
  patch.parents.push_back({no_index, no_index, no_index});
  HoleLoop hole;
  hole.places = other;
  const auto equal = match(rim, other);
  ASSERT_TRUE(equal);
  const HolePatch like = patch_like(patch, *equal, hole);
  ASSERT_EQ(like.places.size(), 7u);
  EXPECT_LT(glm::distance(like.places[6], {8.9, 0.2, 0.7}), 1e-12);
  ASSERT_EQ(like.triangles.size(), 6u);
  std::vector<bool> is_side(6, false);
  for (const CornerTriangle& t : like.triangles) {
    const auto apex = static_cast<std::size_t>(std::find(t.begin(), t.end(), 6u) - t.begin());
    ASSERT_LT(apex, 3u);
    const std::uint32_t from = t[(apex + 1) % 3];
    EXPECT_EQ(t[(apex + 2) % 3], (from + 1) % 6) << "along the loop";
    is_side[from] = true;
  }
  EXPECT_EQ(is_side, std::vector<bool>(6, true));
}

}  // namespace
}  // namespace ryosen::test
