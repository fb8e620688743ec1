// Places about the middle of a mesh, about 1 in size, so that sums of squares neither overflow nor lose the digits that
// matter, wherever the mesh lies and however large it is.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "core/geometry/box.h"

namespace ryosen {

class ScaledPlaces {
 public:
  explicit ScaledPlaces(std::span<const glm::dvec3> places) {
    const Box box = box_of_finite(places);
    if (box.is_empty()) return;
    const glm::dvec3 half = 0.5 * box.highest - 0.5 * box.lowest;
    const double largest = std::max({half.x, half.y, half.z});
    if (largest > 0) std::frexp(largest, &exponent_);
    middle_ = shifted(box.middle(), -exponent_);
  }

  // Exact but for the rounding of one subtraction.
  glm::dvec3 scaled(const glm::dvec3& p) const { return shifted(p, -exponent_) - middle_; }
  glm::dvec3 restored(const glm::dvec3& q) const { return shifted(q + middle_, exponent_); }
  // The same without moving the middle to the origin: exact but for what is far smaller than the mesh.
  glm::dvec3 scaled_alone(const glm::dvec3& p) const { return shifted(p, -exponent_); }
  double scaled_length(double length) const { return std::ldexp(length, -exponent_); }
  double restored_length(double length) const { return std::ldexp(length, exponent_); }

 private:
  static glm::dvec3 shifted(const glm::dvec3& p, int exponent) {
    return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  }

  int exponent_ = 0;
  glm::dvec3 middle_{0.0};  // scaled
};

}  // namespace ryosen
