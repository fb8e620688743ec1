// On which side of a face a point lies: exactly, and mostly by one plane in doubles.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "ryosen/geometry/predicates.h"

namespace ryosen::hull {

struct FacePlane {
  glm::dvec3 normal;
  glm::dvec3 base;
  // A height beyond this has the right sign, for every point within the reach; infinite where magnitudes forbid to say
  // so.
  double error;

  // A multiple of the height of a point above the plane, rounded.
  double height(const glm::dvec3& p) const {
    return normal.x * (p.x - base.x) + normal.y * (p.y - base.y) + normal.z * (p.z - base.z);
  }
};

// By axis, the largest distance of two of these points, at least one.
inline glm::dvec3 reach_of(std::span<const glm::dvec3> points) {
  glm::dvec3 low(points[0]), high(points[0]);
  for (const glm::dvec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return high - low;
}

// Of the plane through three points, counter-clockwise seen from above. `reach`: by axis at least the distance of any
// two points that are asked about.
inline FacePlane face_plane(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& reach) {
  const glm::dvec3 u = b - a, v = c - a;
  const double x1 = u.y * v.z, x2 = u.z * v.y, y1 = u.z * v.x, y2 = u.x * v.z, z1 = u.x * v.y, z2 = u.y * v.x;
  const double size = (std::abs(x1) + std::abs(x2)) * reach.x + (std::abs(y1) + std::abs(y2)) * reach.y +
                      (std::abs(z1) + std::abs(z2)) * reach.z;
  // The bound of orient3d for the largest size that any point may have, under its limits on magnitudes.
  const bool is_safe = size > 1e-200 && size <= 1e+300 && reach.x + reach.y + reach.z < 1e+100;
  return {{x1 - x2, y1 - y2, z1 - z2}, a, is_safe ? 1e-15 * size : std::numeric_limits<double>::infinity()};
}

// The sign of the height of p above the plane through a, b, c; exact.
inline int side(const FacePlane& plane, double height, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                const glm::dvec3& p) {
  if (height > plane.error) return 1;
  if (height < -plane.error) return -1;
  return orient3d(a, b, c, p);
}

}  // namespace ryosen::hull
