// Taking away the points that lie deep inside, before a hull is built of the others.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen::hull {

struct OuterPoints {
  std::vector<std::uint32_t> numbers;  // ascending
  std::size_t finite = 0;              // how many of all points are
};

// The finite points that may be extreme or equal to an extreme one: a few percent of points that fill a body, all where
// most are extreme. From the hull of a sample and a point inside it, a grid of
// directions gets places that are certainly within the hull, by exact signs; what lies well below these in its
// direction goes. The same points for any number of threads. Cost: O(n), some nanoseconds a point.
OuterPoints outer_points(std::span<const glm::dvec3> points);

}  // namespace ryosen::hull
