// The convex polygon of points in a plane.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace ryosen::hull {

// Of distinct points that are not all collinear: the extreme ones counter-clockwise, by the chains of [Andrew79].
// Exact. Cost: O(n log n).
std::vector<std::uint32_t> planar_hull(std::span<const glm::dvec2> points);

}  // namespace ryosen::hull
