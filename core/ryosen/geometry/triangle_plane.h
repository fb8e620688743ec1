// The plane of a triangle, in doubles: a filter before meet_elsewhere (triangles_meet.h) for one triangle against many.
#pragma once

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ryosen {

class TrianglePlane {
 public:
  TrianglePlane() = default;
  explicit TrianglePlane(const std::array<glm::dvec3, 3>& t) : origin_(t[0]) {
    const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0];
    const glm::dvec3 first(u.y * v.z, u.z * v.x, u.x * v.y), second(u.z * v.y, u.x * v.z, u.y * v.x);
    normal_ = first - second;
    size_ = glm::abs(first) + glm::abs(second);
  }

  // True only where all three corners lie on one side of the plane, strictly; often false where they do.
  bool is_clear_of(const std::array<glm::dvec3, 3>& t) const {
    const int side = clear_side(t[0]);
    return side != 0 && clear_side(t[1]) == side && clear_side(t[2]) == side;
  }

 private:
  // As the filter of orient3d (predicates.cpp), about another corner; 0 where rounding may hide the sign.
  int clear_side(const glm::dvec3& p) const {
    const glm::dvec3 d = p - origin_, far = glm::abs(d);
    const double det = glm::dot(normal_, d), size = glm::dot(size_, far), reach = far.x + far.y + far.z;
    if (!(size > 1e-200 && size <= 1e+300 && reach < 1e+100 && std::abs(det) > 8e-16 * size)) return 0;
    return det > 0.0 ? 1 : -1;
  }

  glm::dvec3 origin_{0.0}, normal_{0.0}, size_{0.0};
};

}  // namespace ryosen
