#include "ryosen/hull/fan_sectors.h"

#include "ryosen/geometry/exact_sum.h"

namespace ryosen::hull {

InsidePoint::InsidePoint(const std::array<glm::dvec3, 4>& corners) : corners_(corners) {
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& corner : corners) middle += corner / 4.0;
  const auto& [a, b, c, d] = corners;
  const int sign = orient3d(a, b, c, d);
  if (orient3d(a, b, c, middle) == sign && orient3d(b, a, d, middle) == sign && orient3d(c, b, d, middle) == sign &&
      orient3d(a, c, d, middle) == sign)
    rounded_ = middle;
}

// The sum over the corners a of the determinants of a - d, b - d, c - d: four times that of their mean.
int InsidePoint::side_of_mean(const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) const {
  exact::ProductSum<3> sum;
  for (const glm::dvec3& a : corners_) exact::add_determinant_from(sum, a, b, c, d);
  return -sum.sign();
}

}  // namespace ryosen::hull
