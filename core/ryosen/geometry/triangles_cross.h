// Approximate test whether two triangles in space intersect transversally.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace ryosen {

// True if an edge of one certainly passes through the interior of the other. Touching, shared corners or edges and
// coplanar overlap do not count, nor cases that rounding leaves undecided: for warnings, not for combinatorial
// decisions. O(1).
bool triangles_cross(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b);

}  // namespace ryosen
