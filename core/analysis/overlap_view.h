// Ways to look at triangles so that boxes tell apart what is apart.
#pragma once

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>
#include <limits>

#include "core/base/handle.h"
#include "core/geometry/triangles_meet.h"

namespace ryosen {

// Intervals of three coordinates and a fourth. By floats: where two boxes of doubles overlap, so do these, because
// rounding keeps the order of numbers.
struct OverlapBox {
  static constexpr std::size_t sides = 4;
  std::array<float, sides> lowest, highest;

  static OverlapBox of_nothing() {
    constexpr float far = std::numeric_limits<float>::infinity();
    return {{far, far, far, far}, {-far, -far, -far, -far}};
  }
  // Without branches, which nobody could foretell.
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
  // Half of the surface of the first three sides.
  float size() const {
    const float x = highest[0] - lowest[0], y = highest[1] - lowest[1], z = highest[2] - lowest[2];
    return x * y + y * z + z * x;
  }
};

// A map of space, or of the directions from a point, to a space of boxes. Whatever triangles have in common lies in the
// boxes of each of them; only what they have in common at the point itself, where that is a corner of both, does not
// count.
class OverlapView {
 public:
  // Places, moved to the origin and scaled, then turned.
  OverlapView(const glm::dvec3& origin, double scale, const glm::dmat3& axes)
      : origin_(origin), scale_(scale), axes_(axes) {}
  // The directions from a tip, where many triangles meet whose boxes all overlap: thin arcs for these, apart from each
  // other but for neighbours. Directions end on the octahedron around the tip, along whose sides what is straight stays
  // straight.
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

// The axes of a view whose last is the one given; those of space where that has no direction.
glm::dmat3 axes_along(const glm::dvec3& axis);

// A sum of vectors that may point either way: each is added so that it does not shorten the sum.
class AlignedSum {
 public:
  void add(const glm::dvec3& v);
  const glm::dvec3& value() const { return sum_; }

 private:
  glm::dvec3 sum_{0.0};
};

}  // namespace ryosen
