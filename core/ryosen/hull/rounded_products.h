// Products of differences of points, right to nearly the last bit also where what is multiplied nearly cancels.
#pragma once

#include <glm/vec3.hpp>

namespace ryosen::hull {

// Of places below 1 in magnitude. What falls below the smallest doubles is lost. Cost: a few nanoseconds, where the
// terms nearly cancel a few microseconds.
glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);  // (b - a) x (c - a)
// (b - a) x (c - a) . (d - a)
double six_volumes_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

}  // namespace ryosen::hull
