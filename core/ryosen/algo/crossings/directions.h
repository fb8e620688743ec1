// What lies where as it is seen from a point, as regions of directions: what two triangles have no direction in common
// meet at most at that point.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "ryosen/geometry/box.h"
#include "ryosen/geometry/frustum.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen::directions {

// From one place to another. Its largest coordinate is 1, of either sign; all are 0 where that is the same place, and
// not finite where it is too far.
glm::dvec3 direction(const glm::dvec3& from, const glm::dvec3& to);
inline bool is_somewhere(const glm::dvec3& direction) { return is_finite(direction) && direction != glm::dvec3(0); }

// The directions in which a triangle lies; perhaps some more, all of them where that cannot be told, and where a corner
// of another number than that of the point lies at its place.
Frustum cone_of(const NumberedTriangle& triangle, std::uint32_t point, const glm::dvec3& place);

// An edge between two places, and what is seen along it: the directions across it in which others lie.
struct Spine {
  glm::dvec3 a, b;
};
// Where a triangle at that edge is seen, by its third corner, within rounding. The largest coordinate of a direction is
// 1; everywhere where it cannot be told.
Box page_of(const Spine& spine, const glm::dvec3& third);
// Where those pages are seen that a triangle meets elsewhere than at the ends, where it may have corners of these
// numbers; perhaps some more.
Frustum wedge_of(const NumberedTriangle& triangle, std::span<const std::uint32_t> numbers, const Spine& spine);

// A triangle as thick as rounding; its box where it is too large or small for that.
Frustum slab_of(const TriangleCorners& triangle);

}  // namespace ryosen::directions
