// Places about the middle of a mesh, about 1 in size, so that sums of squares neither overflow nor lose the digits that
// matter, wherever the mesh lies and however large it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/vec3.hpp>

#include "ryosen/geometry/box.h"

namespace ryosen {

class ScaledPlaces {
 public:
  explicit ScaledPlaces(std::span<const glm::dvec3> places) {
    const Box box = box_of_finite(places);
    if (box.is_empty()) return;
    const glm::dvec3 half = 0.5 * box.highest - 0.5 * box.lowest;
    const double largest = std::max({half.x, half.y, half.z});
    if (largest > 0) std::frexp(largest, &exponent_);
    down_ = factor(-exponent_);
    up_ = factor(exponent_);
    middle_ = scaled_alone(box.middle());
  }

  // Exact but for the rounding of one subtraction.
  glm::dvec3 scaled(const glm::dvec3& p) const { return scaled_alone(p) - middle_; }
  glm::dvec3 restored(const glm::dvec3& q) const { return shifted(q + middle_, up_, exponent_); }
  // The same without moving the middle to the origin: exact but for what is far smaller than the mesh.
  glm::dvec3 scaled_alone(const glm::dvec3& p) const { return shifted(p, down_, -exponent_); }
  double scaled_length(double length) const { return std::ldexp(length, -exponent_); }
  double restored_length(double length) const { return std::ldexp(length, exponent_); }

 private:
  // 2^exponent; 0 where a double does not hold it.
  static double factor(int exponent) { return std::abs(exponent) <= 1000 ? std::ldexp(1.0, exponent) : 0; }
  static glm::dvec3 shifted(const glm::dvec3& p, double factor, int exponent) {
    if (factor > 0) return factor * p;
    return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  }

  int exponent_ = 0;
  double down_ = 1, up_ = 1;  // factors
  glm::dvec3 middle_{0.0};    // scaled
};

}  // namespace ryosen
