// The middle of a tetrahedron: a point strictly inside a hull, also where that is no double.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "ryosen/geometry/predicates.h"

namespace ryosen::hull {

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

}  // namespace ryosen::hull
