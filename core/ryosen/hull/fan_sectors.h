// Which of the new faces around a point could be seen from another point.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "ryosen/geometry/predicates.h"

namespace ryosen::hull {

// The middle of a tetrahedron: a point strictly inside a hull, also where that is no double.
class InsidePoint {
 public:
  // Of four points in no plane.
  explicit InsidePoint(const std::array<glm::dvec3, 4>& corners);

  // The side of d of the plane through this point, b and c, as orient3d has it; exact.
  int side(const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) const {
    return rounded_ ? orient3d(*rounded_, b, c, d) : side_of_mean(b, c, d);
  }

 private:
  int side_of_mean(const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) const;

  std::array<glm::dvec3, 4> corners_;
  std::optional<glm::dvec3> rounded_;  // where it lies inside too
};

// The half-planes from the axis, which runs from a point inside the hull to a new corner outside, through the corners
// of the horizon cut space into sectors, each with one new face. A point outside the cone of these faces sees the one
// in its own sector, through which the ray to it from the point inside leaves the hull: so which face that is depends
// on the points taken in alone, not on their order. Finding it takes O(log k) exact signs for k faces.
class FanSectors {
 public:
  using Horizon = std::span<const std::uint32_t>;  // first corners of the edges, counter-clockwise seen from outside

  FanSectors(std::span<const glm::dvec3> points, const InsidePoint& inside, const glm::dvec3& tip, Horizon horizon)
      : points_(points), inside_(inside), tip_(tip), horizon_(horizon) {
    // The corners strictly less than half a turn after the first one come first.
    std::size_t low = 1, high = horizon.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (turn(0, points_[horizon_[middle]]) > 0)
        low = middle + 1;
      else
        high = middle;
    }
    turned_ = low;
  }

  std::size_t sector_of(const glm::dvec3& p) const {
    const bool is_in_first_half = is_left(0, p);
    std::size_t low = is_in_first_half ? 1 : turned_, high = is_in_first_half ? turned_ : horizon_.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (is_left(middle, p))
        low = middle + 1;
      else
        high = middle;
    }
    return low - 1;
  }

 private:
  // +1 where p is less than half a turn after this corner, 0 in line with it or opposite.
  int turn(std::size_t corner, const glm::dvec3& p) const { return inside_.side(tip_, points_[horizon_[corner]], p); }
  bool is_left(std::size_t corner, const glm::dvec3& p) const { return turn(corner, p) >= 0; }

  std::span<const glm::dvec3> points_;
  const InsidePoint& inside_;
  glm::dvec3 tip_;
  Horizon horizon_;
  std::size_t turned_ = 0;
};

}  // namespace ryosen::hull
