// How long and how thin a convex hull is: its farthest pair of points and its smallest width.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/hull/convex_hull.h"

namespace ryosen {

struct HullExtent {
  std::vector<std::uint32_t> farthest = {};  // two extreme points, ascending; none below dimension 1
  double diameter = 0;                       // their distance
  // The least distance of two parallel lines or planes with the hull between them; 0 below dimension 2, and in the
  // plane of a polygon.
  double width = 0;
  // What lies on them, by the points: of a polygon a side and a corner; of a solid a facet and a corner, or two
  // edges. None below dimension 2.
  std::array<std::vector<std::uint32_t>, 2> between = {};

  friend bool operator==(const HullExtent&, const HullExtent&) = default;
};

// Which elements are opposite, and which of two pairs is farther, is exact: of equally far pairs the lexicographically
// first. Numbers are rounded, in units of the points. By calipers in two dimensions [Shamos78], O(corners). In three
// dimensions over the pairs of opposite elements [Houle88], with those left out that cannot be longer or thinner than
// what is known: about O(h log h) for h facets of usual shapes; at worst, where very many edges are opposite to very
// many others, or corners with very many facets to very many facets, O(h^2). A cancelled one is that of nothing.
HullExtent hull_extent(std::span<const glm::dvec3> points, const ConvexHull& hull, Progress& progress);
HullExtent hull_extent(std::span<const glm::dvec3> points, const ConvexHull& hull);

// The farthest pair of either, and the smallest width of those that have one: of several hulls the extremes.
HullExtent extremes(const HullExtent& one, const HullExtent& other);

// "Farthest apart: v3 and v7, 2.5. Smallest width: 1.25, between v0 v1 v2 and v7." Empty below dimension 1.
Text extent_sentence(const HullExtent& extent);

}  // namespace ryosen
