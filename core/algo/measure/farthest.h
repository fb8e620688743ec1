// How far a triangle is at most from a surface: bounds, and their refinement.
#pragma once

#include <array>
#include <cstdint>

#include "core/algo/measure/subtriangles.h"
#include "core/pick/triangle_tree.h"

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

// When a bound above a distance that occurs is good enough: by a share of that, or by an absolute amount.
struct FarEnough {
  double share, amount;
  double from(double found) const { return found + std::max(found * share, amount); }
};

// No point of the cell is farther from `to` than this. It tries harder the longer it is not at most `wanted`.
double bound_of(const TriangleTree& to, const FarthestCell& cell, double wanted);

struct FarthestFound {
  double bound = 0;         // of all points of the cell
  double distance = 0;      // that a point was found to have; that given at first where none has more
  glm::dvec3 place{0.0};    // that point, unless none has more
  bool is_farther = false;  // than given at first
  std::uint32_t steps = 0;
};
// Halves the cell until the bound is at most `enough` of the largest distance found, in it or before (`found`), or after
// so many steps.
FarthestFound farthest_in(const TriangleTree& to, const FarthestCell& cell, double found, FarEnough enough,
                          std::uint32_t most_steps);

}  // namespace ryosen
