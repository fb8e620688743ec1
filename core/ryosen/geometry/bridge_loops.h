// Joins the loops of a polygon with holes into one closed corner list, as in files.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen {

// Joins the loops, the outer one first, by bridges traversed in both directions: the shortest that cross nothing in the
// projection along the polygon's dominant axis or, if none is visible (crossing loops), the shortest of all. Corners
// are numbered consecutively over the loops; the list starts with corner 0 and keeps the sides of every loop in order.
// With more than 2000 corners, or when the budget of visibility tests runs out, only edges of a triangulation are
// candidates. O(n² log n) up to 2000 corners, O(n log n) beyond, plus the bounded visibility tests.
std::vector<std::uint32_t> bridge_loops(std::span<const std::span<const glm::dvec3>> loops);

}  // namespace ryosen
