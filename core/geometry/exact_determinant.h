// Determinants of places as exact sums, for predicates of any size of numbers.
#pragma once

#include <glm/vec3.hpp>

#include "core/geometry/exact_sum.h"

namespace ryosen::exact {

// The determinant of three places, or its opposite.
inline void add_determinant(ProductSum<3>& sum, const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w,
                            bool negate = false) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(u[i], v[j], w[k], negate);
    sum.add_product(u[i], v[k], w[j], !negate);
  }
}

// That of a - d, b - d and c - d, expanded into four of three places each, so that nothing is subtracted.
inline void add_determinant_from(ProductSum<3>& sum, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                 const glm::dvec3& d) {
  add_determinant(sum, a, b, c);
  add_determinant(sum, b, c, d, true);
  add_determinant(sum, a, c, d);
  add_determinant(sum, a, b, d, true);
}

}  // namespace ryosen::exact
