// Convex hulls as shapes: their sizes, their faces as a polygon list, and the hulls of parts of many points, of some or
// of each connected component of a mesh.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/hull/convex_hull.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen {

struct HullSize {
  double volume = 0;  // of a solid
  double area = 0;    // of all facets; of a polygon that of one side
};

// In units of the points, rounded; infinite where beyond the largest double. Cost: O(corners).
HullSize hull_size(std::span<const glm::dvec3> points, const ConvexHull& hull);

enum class HullFaces { facets, triangles };  // triangles: of each facet the fan from its lowest number

struct HullList {
  IndexedMesh list;                                            // the extreme points by ascending number, and the faces
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wires;  // the segment of dimension 1, by numbers in the list
};
// Behind what is in the list already.
void add_hull(std::span<const glm::dvec3> points, const ConvexHull& hull, HullFaces faces, HullList& to);

// "All points lie in a plane: the hull is a polygon of 5 vertices (dimension 2)."
Text hull_sentence(const ConvexHull& hull);
// "Volume 1, area 6." Empty below dimension 2.
Text size_sentence(const ConvexHull& hull, const HullSize& size);
// "The hulls of 3 components have 12 vertices and 9 facets. Volume 1, area 6 together."
Text hulls_sentence(std::size_t count, std::size_t vertices, std::size_t facets, const HullSize& size);

// The hull of the points with these numbers, ascending; its numbers are those of all points. Cost: that of
// convex_hull().
ConvexHull hull_of_some(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers, Progress& progress);

using PointPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The points that faces and edges without a face join, ascending, by their lowest one; a point by itself is a
// component too. Each has all its points in one list. Cost: O(corners + edges + points).
std::vector<std::vector<std::uint32_t>> joined_points(const IndexedMesh& list, const PointPairs& edges);

}  // namespace ryosen
