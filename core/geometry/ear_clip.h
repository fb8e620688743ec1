// Triangles for polygons that no sweep can do justice: self-intersecting, flat, or without any inside.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/geometry/triangulate.h"

namespace ryosen {

// Appends size - 2 triangles of the closed corner list `corners` (numbers into `points`), ears first; where no ear is
// left the next convex corner goes, or else any. Always ends: after a fixed number of point tests (about 0.3 s) the
// rest becomes a fan. The same input gives the same triangles. Quadratic, hence only a last resort.
void clip_ears(std::span<const glm::dvec2> points, std::span<const std::uint32_t> corners,
               std::vector<CornerTriangle>& out);

}  // namespace ryosen
