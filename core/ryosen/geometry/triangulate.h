// Triangulation of a polygon in space; drawing, picking and measuring all use this one.
//
// The polygon is projected along the dominant axis of its normal; decisions use exact predicates on the two remaining
// original coordinates, so nothing is rounded. A polygon that is simple in that projection gets a valid triangulation:
// no triangle outside, none inverted, none degenerate unless corners touch an edge or another corner. Weakly simple
// ones (bridges, touching or repeated corners) are handled too. Anything else (self-intersecting, flat, zero area, not
// finite) still gets the same number of triangles, using every corner, deterministically. Cost O(n log n), plus at most
// a few hundred milliseconds for large self-intersecting polygons. Thread-safe; scratch memory is kept per thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen {

// Corner numbers of a triangle, from 0 within the polygon, with the polygon's orientation.
using CornerTriangle = std::array<std::uint32_t, 3>;

// Replaces `out` by the n - 2 triangles of a polygon of n corners (none for fewer than three). Every side of the
// polygon is a side of exactly one triangle.
void triangulate(std::span<const glm::dvec3> polygon, std::vector<CornerTriangle>& out);

// The same for a polygon with holes: the outer loop first, then the holes, oppositely oriented. Corners are numbered
// consecutively over the loops. With n corners and h holes there are n + 2 h - 2 triangles; loops without corners are
// skipped and not counted.
void triangulate_loops(std::span<const std::span<const glm::dvec3>> loops, std::vector<CornerTriangle>& out);

}  // namespace ryosen
