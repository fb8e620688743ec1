// Normal, area and volume share of a polygon in space by Newell's sum, safe against overflow and underflow.
//
// Polygons may be concave, non-planar or degenerate and may have any number of corners (fewer than three: zero). All
// coordinates are finite; O(n), no allocation.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

// Direction of the normal (counter-clockwise corners seen from its tip) with the area as length. Components may
// overflow to infinity or underflow to zero only if the area itself does.
glm::dvec3 vector_area(std::span<const glm::dvec3> polygon);

// Area of the polygon projected along its normal: the length of vector_area.
double polygon_area(std::span<const glm::dvec3> polygon);

// Unit normal; the zero vector if the sum vanishes. Correct even if the area underflows or overflows a double.
glm::dvec3 polygon_normal(std::span<const glm::dvec3> polygon);

// Signed volume of the cone from `apex` over the polygon, fanned from the mean of its corners. Summed over the faces of
// a closed, outward-oriented surface it is the volume, for any apex; one near the mesh keeps rounding small.
double polygon_volume(std::span<const glm::dvec3> polygon, const glm::dvec3& apex);

}  // namespace ryosen
