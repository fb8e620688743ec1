// Exact signs of small determinants: on which side, collinear or not, for any finite doubles.
//
// Every function answers for the stored doubles without rounding, denormals and values near the largest double
// included. A floating-point filter settles nearly all calls; the rest go to expansions [Shewchuk97], and numbers
// outside their safe range to a fixed-point accumulator wide enough for every product of doubles [Kulisch08].
// Precondition everywhere: coordinates are finite (others give 0, or "collinear"). No allocation; a few nanoseconds
// when the filter decides, below half a microsecond otherwise (orient3d: some microseconds).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

// +1 if a, b, c turn counter-clockwise (c lies left of the line from a to b), -1 if clockwise, 0 if on one line.
int orient2d(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

// +1 if d lies on the side of the plane through a, b, c from which they run counter-clockwise, -1 if on the other, 0 if
// on the plane or if a, b, c lie on one line.
int orient3d(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

// Sign of component `axis` (0, 1, 2) of the cross product (b - a) x (c - a).
int cross_component_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int axis);

// Whether three points lie on one line or coincide.
bool are_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Whether all points lie on one line or coincide; true for fewer than three points. O(n).
bool are_collinear(std::span<const glm::dvec3> points);

// The same for the positions of a face's corners.
bool are_collinear(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> corners);

}  // namespace ryosen
