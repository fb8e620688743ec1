// Triangles of a surface that is measured, cut into equal ones, and how far each is at most from another surface.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "ryosen/geometry/trees/triangle_tree.h"

namespace ryosen {

using TrianglePlaces = std::array<glm::dvec3, 3>;

// Point `along` of line `line`, both from 0; line 0 is the first corner, line k the side that faces it. Corners are
// exact.
inline glm::dvec3 lattice_point(const TrianglePlaces& t, std::uint32_t k, std::uint32_t line, std::uint32_t along) {
  if (line == 0) return t[0];
  if (line == k && (along == 0 || along == k)) return t[along == 0 ? 1 : 2];
  return (double(k - line) * t[0] + double(line - along) * t[1] + double(along) * t[2]) / double(k);
}

// One of the k * k similar triangles, by lines of 1, 3, 5 ... from the first corner on. k < 30000.
inline TrianglePlaces subtriangle(const TrianglePlaces& t, std::uint32_t k, std::uint32_t index) {
  if (k == 1) return t;
  auto line = static_cast<std::uint32_t>(std::sqrt(double(index)));
  while (line * line > index) --line;
  while ((line + 1) * (line + 1) <= index) ++line;
  const std::uint32_t place = index - line * line, along = place / 2;
  if (place % 2 == 0)
    return {lattice_point(t, k, line, along), lattice_point(t, k, line + 1, along),
            lattice_point(t, k, line + 1, along + 1)};
  return {lattice_point(t, k, line, along), lattice_point(t, k, line + 1, along + 1),
          lattice_point(t, k, line, along + 1)};
}

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

  // Whether a corner before has the same nearest triangle.
  bool is_repeated(std::size_t corner) const {
    for (std::size_t k = 0; k < corner; ++k)
      if (near[k].triangle == near[corner].triangle) return true;
    return false;
  }
};

// No point of the cell is farther from `to` than this. It tries harder the longer it is not at most `wanted`.
double bound_of(const TriangleTree& to, const FarthestCell& cell, double wanted);

}  // namespace ryosen
