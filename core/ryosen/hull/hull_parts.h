// Convex hulls of parts of many points: of some, and of each connected component of a mesh.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/hull/convex_hull.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen {

// That of the points with these numbers, ascending; its numbers are those of all points. Cost: that of convex_hull().
ConvexHull hull_of_some(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers, Progress& progress);

using PointPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The points that faces and edges without a face join, ascending, by their lowest one; a point by itself is a
// component too. Each has all its points in one list. Cost: O(corners + edges + points).
std::vector<std::vector<std::uint32_t>> joined_points(const IndexedMesh& list, const PointPairs& edges);

}  // namespace ryosen
