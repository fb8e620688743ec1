#include "ryosen/io/stl_facets.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace ryosen {
namespace {

std::string facets_of(const std::vector<glm::vec3>& corners, std::uint16_t last_attribute = 0) {
  std::string bytes;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (c % 3 == 0) bytes.append(12, '\x7f');
    bytes.append(reinterpret_cast<const char*>(&corners[c]), 12);
    if (c % 3 != 2) continue;
    const std::uint16_t attribute = c + 1 == corners.size() ? last_attribute : std::uint16_t{0};
    bytes.append(reinterpret_cast<const char*>(&attribute), 2);
  }
  return bytes;
}

// Corners at few different places, with both zeros and, when wanted, numbers that are not finite.
std::vector<glm::vec3> random_corners(std::size_t count, int places, bool finite, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] {
    const int i = static_cast<int>(random() % static_cast<unsigned>(places));
    if (i == 0) return random() % 2 ? 0.0f : -0.0f;
    if (!finite && i == 1) return std::numeric_limits<float>::quiet_NaN();
    if (!finite && i == 2) return std::numeric_limits<float>::infinity();
    return static_cast<float>(i) * 0.1f;
  };
  std::vector<glm::vec3> corners(count);
  for (glm::vec3& corner : corners) corner = {number(), number(), number()};
  return corners;
}

TEST(weld_facets, any_number_of_threads_numbers_as_one_by_one_does) {
  for (const int places : {1, 4, 10, 60}) {
    for (const bool finite : {true, false}) {
      const std::vector<glm::vec3> places_of = random_corners(30000, places, finite, static_cast<unsigned>(places));
      const std::string bytes = facets_of(places_of);
      std::vector<glm::dvec3> expected_positions;
      std::vector<std::uint32_t> expected;
      Welder welder(expected_positions, 0);
      for (const glm::vec3& place : places_of) expected.push_back(welder.number(glm::dvec3(place)));
      for (const unsigned threads : {1u, 2u, 5u}) {
        std::vector<glm::dvec3> positions;
        std::vector<std::uint32_t> corners;
        const StlFacetFindings found = weld_facets(StlFacets(bytes.data(), 10000), threads, positions, corners);
        EXPECT_EQ(corners, expected) << places << " " << threads;
        ASSERT_EQ(positions.size(), expected_positions.size());
        EXPECT_EQ(std::memcmp(positions.data(), expected_positions.data(), 24 * positions.size()), 0)
            << "the first corner gives its coordinates, and its zero";
        EXPECT_EQ(found.all_finite, finite || places < 2);
        EXPECT_FALSE(found.has_attributes);
      }
    }
  }
}

TEST(weld_facets, finds_the_last_attribute) {
  const std::string bytes = facets_of(random_corners(30, 5, true, 1), 0x100);
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> corners;
  EXPECT_TRUE(weld_facets(StlFacets(bytes.data(), 10), 2, positions, corners).has_attributes);
}

TEST(weld_facets, nothing_is_nothing) {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> corners;
  EXPECT_TRUE(weld_facets(StlFacets(nullptr, 0), 2, positions, corners).all_finite);
  EXPECT_TRUE(positions.empty() && corners.empty());
}

}  // namespace
}  // namespace ryosen
