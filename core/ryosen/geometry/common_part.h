// Where two triangles in space meet, by doubles.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "ryosen/geometry/box.h"

namespace ryosen {

// A box of the points that both triangles have in common, up to rounding: of the segment in which they cross, or of
// what their boxes have in common where they lie in one plane; empty where neither is found. O(1).
Box box_of_common_part(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b);

}  // namespace ryosen
