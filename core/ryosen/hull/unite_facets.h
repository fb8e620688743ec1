// Unites coplanar triangles of a hull into facets.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/hull/solid_hull.h"

namespace ryosen::hull {

// Polygons by the numbers of their corners.
struct FacetList {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> offsets{0};

  std::size_t count() const { return offsets.size() - 1; }
  std::span<const std::uint32_t> facet(std::size_t f) const {
    return {corners.data() + offsets[f], offsets[f + 1] - offsets[f]};
  }
};

// Triangles in one plane become one polygon, whose corners are those of its boundary that do not lie between their
// neighbours. Exact. Cost: O(triangles).
FacetList unite_facets(std::span<const glm::dvec3> points, std::span<const HullTriangle> triangles);

// With each corner replaced by its entry of `numbers`, each polygon from its lowest one, in lexicographic order.
// Polygons of one hull: no two share their first two corners. Cost: O(corners + largest number).
FacetList in_order(const FacetList& facets, std::span<const std::uint32_t> numbers);

}  // namespace ryosen::hull
