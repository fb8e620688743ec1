// Plane-sweep triangulation of polygons with holes, top to bottom.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "ryosen/geometry/triangulate.h"

namespace ryosen {

// The corners of one or more loops, numbered consecutively; the interior is left of every side.
struct PlanarLoops {
  std::span<const glm::dvec2> points;
  std::span<const std::uint32_t> ends;  // one past the last corner of each loop
};

enum class SweepMode {
  strict,   // gives up if a triangle would be inverted: the loops are not even weakly simple
  tolerant  // continues, so that loops with a few crossings get a triangulation with a few inverted triangles
};

// Appends the triangles to `out`; false if it failed, with an incomplete set in `out`. O(n log n).
bool sweep_triangles(const PlanarLoops& loops, SweepMode mode, std::vector<CornerTriangle>& out);

}  // namespace ryosen
