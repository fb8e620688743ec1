// Triangles of a polygon in space: the one answer to "which triangles does this face consist of", for drawing, picking
// and measuring alike.
//
// The polygon is looked at along the axis in which its normal is largest; decisions are exact signs of the two original
// coordinates that remain, so nothing is rounded. A polygon that is simple in that view gets a right triangulation: no
// triangle outside, none turned over, none flat unless corners touch an edge or another corner. Weakly simple ones
// (bridges walked both ways, touching corners, repeated corners) are right too. Anything else (self-intersecting, flat,
// of no area, not finite) still gets as many triangles, each corner used, the same ones every time.
// Cost O(n log n); beyond that bound at most some hundred milliseconds for large self-intersecting polygons.
// Thread-safe; scratch memory is kept per thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen {

// Corner numbers of a triangle, counted from 0 within the polygon, in the polygon's orientation.
using CornerTriangle = std::array<std::uint32_t, 3>;

// Replaces `out` by the n - 2 triangles of a polygon of n corners (none for fewer than three). Every side of the
// polygon is a side of exactly one triangle.
void triangulate(std::span<const glm::dvec3> polygon, std::vector<CornerTriangle>& out);

// The same for a polygon with holes: the outer loop first, then the holes, which run the other way round. Corners are
// numbered on from loop to loop. With n corners and h holes there are n + 2 h - 2 triangles; holes need a corner at
// least, and loops without corners are skipped.
void triangulate_loops(std::span<const std::span<const glm::dvec3>> loops, std::vector<CornerTriangle>& out);

}  // namespace ryosen
