// Ear clipping: the fallback for polygons that the sweep cannot triangulate (self-intersecting, flat or empty).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "ryosen/geometry/triangulate.h"

namespace ryosen {

// Appends size - 2 triangles of the closed corner list `corners` (numbers into `points`), ears first; if there is no
// ear, it cuts the next convex corner, or else any. Terminates: after a fixed number of point tests (about 0.3 s) the
// rest becomes a fan. Deterministic. O(n²) and worse within that limit.
void clip_ears(std::span<const glm::dvec2> points, std::span<const std::uint32_t> corners,
               std::vector<CornerTriangle>& out);

}  // namespace ryosen
