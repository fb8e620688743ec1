// One closed walk over all loops of a polygon with holes, as files write it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen {

// Joins the loops, the outer one first, by bridges that are walked both ways, the shortest ones that meet nothing in the
// view along the polygon's normal; where nothing is visible (loops that cross) the shortest of all. Corners are numbered
// on from loop to loop; the walk begins with corner 0 and keeps the sides of every loop in their order. Of many corners
// (more than 2000), and where the shortest pairs see nothing for long, only bridges along a triangulation are considered.
// O(n² log n) up to there, O(n log n) beyond, and a bounded search for what is visible.
std::vector<std::uint32_t> bridge_loops(std::span<const std::span<const glm::dvec3>> loops);

}  // namespace ryosen
