// Triangles that span a loop in space.
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
  std::vector<glm::dvec3> normals;  // of the face beyond the side from place i to the next; unit, or zero where unknown
  // Whether corners i < k, not neighbours, may be joined by an edge.
  std::function<bool(std::uint32_t, std::uint32_t)> may_join;
};

// Loops with more corners are triangulated by projection.
inline constexpr std::size_t most_weighed_corners = 300;

// The n - 2 triangles, running along the loop and none of them with corners on one line, whose largest angle between
// neighbours, those beyond the loop included, is the smallest, and among these the ones with the least area [Liepa03];
// O(n^3). For loops of more than most_weighed_corners the triangulation of the polygon as it is drawn. None where
// corners that may not be joined, or lie on lines, leave no triangulation.
std::optional<std::vector<CornerTriangle>> triangulate_hole(const HoleLoop& loop);

}  // namespace ryosen
