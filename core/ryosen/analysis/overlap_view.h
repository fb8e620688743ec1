// Coordinate maps in which the bounding boxes of disjoint triangles overlap less often.
#pragma once

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>
#include <limits>

#include "ryosen/base/handle.h"
#include "ryosen/geometry/triangles_meet.h"

namespace ryosen {

// A bounding box in four coordinates. Rounding to float is monotonic, so boxes that overlap in double also overlap in
// float.
struct OverlapBox {
  static constexpr std::size_t sides = 4;
  std::array<float, sides> lowest, highest;

  static OverlapBox of_nothing() {
    constexpr float far = std::numeric_limits<float>::infinity();
    return {{far, far, far, far}, {-far, -far, -far, -far}};
  }
  // Branchless: the outcome is unpredictable.
  bool overlaps(const OverlapBox& b) const {
    int apart = 0;
    for (std::size_t i = 0; i < sides; ++i)
      apart |= static_cast<int>(lowest[i] > b.highest[i]) | static_cast<int>(b.lowest[i] > highest[i]);
    return apart == 0;
  }
  void grow(const OverlapBox& b) {
    for (std::size_t i = 0; i < sides; ++i) {
      lowest[i] = std::min(lowest[i], b.lowest[i]);
      highest[i] = std::max(highest[i], b.highest[i]);
    }
  }
  // Half the surface area in the first three coordinates.
  float size() const {
    const float x = highest[0] - lowest[0], y = highest[1] - lowest[1], z = highest[2] - lowest[2];
    return x * y + y * z + z * x;
  }
};

// A map of space, or of the directions from a point (the tip), to box coordinates. Triangles that intersect have
// overlapping boxes, except if they intersect only at the tip, as a common corner.
class OverlapView {
 public:
  // Positions, translated by the origin, scaled and rotated.
  OverlapView(const glm::dvec3& origin, double scale, const glm::dmat3& axes)
      : origin_(origin), scale_(scale), axes_(axes) {}
  // Directions from a tip at which many triangles meet: their images are thin arcs, which only neighbours share.
  // Directions are projected onto an octahedron around the tip, on whose faces straight lines stay straight.
  static OverlapView from_tip(const glm::dvec3& tip, double scale, std::uint32_t number, const glm::dmat3& axes);

  bool is_from_tip() const { return tip_ != no_index; }
  OverlapBox box_of(const NumberedTriangle& t) const;

 private:
  OverlapBox box_of_places(const NumberedTriangle& t) const;
  OverlapBox box_of_directions(const NumberedTriangle& t) const;

  glm::dvec3 origin_;
  double scale_;
  glm::dmat3 axes_;  // its columns are the axes of the view
  std::uint32_t tip_ = no_index;
};

// An orthonormal frame with the given direction as its last axis; the identity if it has no direction.
glm::dmat3 axes_along(const glm::dvec3& axis);

// A sum of vectors of arbitrary sign: each is negated if needed so that it does not shorten the sum.
class AlignedSum {
 public:
  void add(const glm::dvec3& v);
  const glm::dvec3& value() const { return sum_; }

 private:
  glm::dvec3 sum_{0.0};
};

}  // namespace ryosen
