// The convex hull of any points in space: exact, in every dimension from nothing to a solid.
//
// The answer is a function of the coordinates and of the numbers of the points alone: facets are the true ones
// (triangles in one plane are united), their corners the extreme points, of equal points the lowest number. So it is
// the same for every order in which points are taken in, every seed and every number of threads.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/base/progress.h"

namespace ryosen {

struct ConvexHull {
  int dimension = -1;                           // -1 nothing, 0 a point, 1 a segment, 2 a polygon, 3 a solid
  std::size_t used = 0;                         // how many points are finite; the others are left out
  std::vector<std::uint32_t> vertices;          // the extreme points, ascending
  std::vector<std::uint32_t> corners;           // of all facets
  std::vector<std::uint32_t> facet_offsets{0};  // facets + 1 places in corners

  std::size_t facet_count() const { return facet_offsets.size() - 1; }
  // From its lowest number, counter-clockwise seen from outside. The facets are in lexicographic order.
  std::span<const std::uint32_t> facet(std::size_t f) const {
    return {corners.data() + facet_offsets[f], facet_offsets[f + 1] - facet_offsets[f]};
  }
  friend bool operator==(const ConvexHull&, const ConvexHull&) = default;
};

// Dimension 2 has one facet, seen counter-clockwise from where the largest component of its normal points (of equal
// ones the first); below there is none. All signs are exact, for all finite doubles. Points deep inside are taken
// away first, by a star of directions around a point inside; what is left goes through lists of points outside each
// face, the farthest first, as [Barber96], and in random order [Clarkson89] where that takes long. Cost: for n points
// O(n log n) expected hand-overs from face to face whatever their places, each to one of k new faces by O(log k) exact
// signs; at the peak 10 bytes a point where most are taken away, 360 to 560 for each extreme one. A cancelled one has
// dimension -1 and no vertices.
ConvexHull convex_hull(std::span<const glm::dvec3> points, Progress& progress);
ConvexHull convex_hull(std::span<const glm::dvec3> points);

}  // namespace ryosen
