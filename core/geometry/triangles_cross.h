// Whether two triangles in space cut through each other.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace ryosen {

// True when a side of one certainly passes through the inside of the other. Touching, sharing corners or sides, and
// overlap within one plane do not count, nor does what rounding leaves undecided: meant for warnings, not for
// combinatorial decisions. O(1).
bool triangles_cross(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b);

}  // namespace ryosen
