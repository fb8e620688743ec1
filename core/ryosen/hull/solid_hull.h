// The boundary of the convex hull of points that span space, in triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/base/progress.h"

namespace ryosen::hull {

struct HullTriangle {
  std::array<std::uint32_t, 3> corners;  // counter-clockwise seen from outside, never collinear
  std::array<std::uint32_t, 3> beside;   // triangles beyond the edges from each corner to the next
};

// By outside lists, the farthest point of a list first [Barber96]; where that hands points on too often, what is left
// in random order [Clarkson89]. A face is seen only from strictly above its plane, by exact sign, so no triangle is
// degenerate; triangles in one plane stay apart, and corners may lie within their facet or its edges. `basis`: four of
// the points, in no plane. Cost: see convex_hull.h. Empty where it was cancelled.
std::vector<HullTriangle> solid_hull(std::span<const glm::dvec3> points, const std::array<std::uint32_t, 4>& basis,
                                     Progress& progress);

}  // namespace ryosen::hull
