// A power of two that brings coordinates near 1, so that squares of lengths neither overflow nor vanish, and the
// largest coordinate.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>

#include "ryosen/geometry/is_finite.h"

namespace ryosen {

// The absolutely largest one of the finite places.
inline double largest_finite_coordinate(std::span<const glm::dvec3> places) {
  double most = 0;
  for (const glm::dvec3& p : places)
    if (is_finite(p)) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most;
}

// What the finite ones are to be multiplied by; dividing by it gives them back exactly, unless they were subnormal.
inline double unit_scale(std::span<const glm::dvec3> places) {
  const double most = largest_finite_coordinate(places);
  return most > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(most), -1000, 1000)) : 1;
}

}  // namespace ryosen
