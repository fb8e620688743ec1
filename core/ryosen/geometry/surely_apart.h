// Fast tests that tell for certain that two things have no common point.
#pragma once

#include <array>

#include "ryosen/geometry/box.h"

namespace ryosen {

// Whether an axis separates a triangle from a box, whatever the rounding. False says nothing. Boxes of slivers overlap
// where the slivers are far apart.
bool are_surely_apart(const std::array<glm::dvec3, 3>& triangle, const Box& box);
// The same of two triangles, along their normals and across their sides: also of triangles in one plane.
bool are_surely_apart(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b);

}  // namespace ryosen
