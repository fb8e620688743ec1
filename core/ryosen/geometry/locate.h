// Point-in-polygon test in an axis-aligned projection.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

enum class Place { outside, inside, on };

// The dominant axis of a normal: projecting along it keeps the largest area. triangulate() uses the same one.
int view_axis(const glm::dvec3& normal);
// Where `p` lies relative to the closed polygon (even-odd rule), projected along the axis. Exact for finite
// coordinates. O(n).
Place locate(const glm::dvec3& p, std::span<const glm::dvec3> polygon, int axis);
// Twice the signed area of the polygon projected along view_axis(normal); positive if counter-clockwise seen against
// `normal`.
double projected_area(std::span<const glm::dvec3> polygon, const glm::dvec3& normal);

}  // namespace ryosen
