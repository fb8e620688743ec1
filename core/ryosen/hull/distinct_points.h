// The finite points among many, equal ones once, near ones beside each other.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen::hull {

struct DistinctPoints {
  std::vector<glm::dvec3> places;
  std::vector<std::uint32_t> numbers;  // of each the lowest number that lies there
};

// Of the points with these numbers, ascending. Cost: O(n), and O(k log k) for k of them in one of 2^30 cells.
DistinctPoints distinct_points(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers);

}  // namespace ryosen::hull
