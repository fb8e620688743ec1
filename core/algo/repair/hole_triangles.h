// Triangulation of a hole's boundary loop in space.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/triangulate.h"

namespace ryosen {

struct HoleLoop {
  std::vector<glm::dvec3> places;   // finite
  std::vector<glm::dvec3> normals;  // of the face across the side from i to the next; unit, or zero if unknown
  // Whether the non-adjacent corners i < k may be joined by an edge.
  std::function<bool(std::uint32_t, std::uint32_t)> may_join;
};

// Larger loops are triangulated by projection.
inline constexpr std::size_t most_weighed_corners = 300;

// The n - 2 non-degenerate triangles, oriented along the loop, that minimise the largest fold between neighbours (those
// beyond the loop included), then the area [Liepa03]; O(n^3). For loops of more than most_weighed_corners the
// triangulation of triangulate(). None if forbidden edges or collinear corners leave no triangulation.
std::optional<std::vector<CornerTriangle>> triangulate_hole(const HoleLoop& loop);

}  // namespace ryosen
