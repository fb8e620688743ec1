// Where a point lies in the view of a polygon along an axis.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

enum class Place { outside, inside, on };

// The axis along which a polygon of this normal looks largest, as triangulate() looks at it.
int view_axis(const glm::dvec3& normal);
// Whether `p` lies inside the closed polygon (even-odd), looked at along the axis. Exact for finite coordinates. O(n).
Place locate(const glm::dvec3& p, std::span<const glm::dvec3> polygon, int axis);
// Twice the signed area of the polygon in that view, counter-clockwise positive when `normal` points at the viewer.
double projected_area(std::span<const glm::dvec3> polygon, const glm::dvec3& normal);

}  // namespace ryosen
