// The exact sign of the volume that a closed surface encloses.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "ryosen/geometry/exact_sum.h"

namespace ryosen {

// Add all polygons of the closed surface. A polygon stands for the cone over it from the mean of its corners, or of the
// lowest and highest one by coordinates if it has more than eight. Both lie in the plane of a planar polygon. Reversing
// a polygon negates its share exactly, so two sheets at the same places enclose no volume.

// In doubles, with a bound of the rounding error.
class RoundedVolume {
 public:
  // `lowest` is the lowest corner of the bounding box.
  explicit RoundedVolume(const glm::dvec3& lowest) : lowest_(lowest) {}
  void add(std::span<const glm::dvec3> polygon);
  // None where rounding, overflow or underflow may have changed it.
  std::optional<int> sign() const;

 private:
  void add_cone(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

  glm::dvec3 lowest_;
  double sum_ = 0, rest_ = 0;  // the latter is what rounding took from the former
  double size_ = 0, reach_ = 0;
};

// Without rounding, for all finite doubles. About a microsecond per corner.
class ExactVolume {
 public:
  void add(std::span<const glm::dvec3> polygon);
  int sign() const;

 private:
  std::array<exact::ProductSum<3>, 9> sums_;  // by number of tips, each times 6 and that number
};

}  // namespace ryosen
