// How far a triangle is at most from a surface.
#pragma once

#include <array>
#include <cstdint>

#include "ryosen/analysis/measure/subtriangles.h"
#include "ryosen/geometry/trees/triangle_tree.h"

namespace ryosen {

// Distances that are no more than the rounding of coordinates of magnitude 1 count as none.
inline double without_rounding(double distance) { return distance < 0x1p-50 ? 0.0 : distance; }

inline TriangleTree::Near nearest_of(const TriangleTree& to, const glm::dvec3& p, std::uint32_t hint) {
  TriangleTree::Near near = to.nearest(p, hint);
  near.distance = without_rounding(near.distance);
  return near;
}

// A triangle of the surface that is measured, with what is nearest to its corners.
struct FarthestCell {
  TrianglePlaces corners;
  std::array<TriangleTree::Near, 3> near;
};

// No point of the cell is farther from `to` than this. It tries harder the longer it is not at most `wanted`.
double bound_of(const TriangleTree& to, const FarthestCell& cell, double wanted);

}  // namespace ryosen
