// Determinants of places as exact sums, for predicates of any size of numbers.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "ryosen/geometry/exact_sum.h"

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

// A difference of two places without rounding: of each coordinate what it rounds to, and what is missing to it.
using Difference3 = std::array<Pair, 3>;
inline Difference3 difference(const glm::dvec3& p, const glm::dvec3& q) {
  return {two_sum(p.x, -q.x), two_sum(p.y, -q.y), two_sum(p.z, -q.z)};
}

// Adds the product of three pairs, or its opposite. Zero terms are skipped: nearly all low parts are zero.
inline void add_product(Expansion<192>& sum, const Pair& x, const Pair& y, const Pair& z, bool negate) {
  for (const double a : {x.low, x.high}) {
    if (a == 0.0) continue;
    for (const double b : {y.low, y.high}) {
      if (b == 0.0) continue;
      for (const double c : {z.low, z.high})
        if (c != 0.0) sum.add_product(negate ? -a : a, b, c);
    }
  }
}

// The determinant of three differences, of places in whose products nothing over- or underflows.
inline Expansion<192> determinant(const Difference3& u, const Difference3& v, const Difference3& w) {
  Expansion<192> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    add_product(sum, u[i], v[j], w[k], false);
    add_product(sum, u[i], v[k], w[j], true);
  }
  return sum;
}

}  // namespace ryosen::exact
