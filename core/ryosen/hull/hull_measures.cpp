#include "ryosen/hull/hull_measures.h"

#include <cstdio>

#include "ryosen/geometry/exact_sum.h"

namespace ryosen::hull {

namespace {

// Less of the size of the terms than this is left, and too many of its bits are wrong.
constexpr double much_cancelled = 1e-3;

double exact_component(const exact::Difference3& u, const exact::Difference3& v, std::size_t j, std::size_t k) {
  exact::Expansion<16> sum;
  for (const double a : {u[j].low, u[j].high})
    for (const double b : {v[k].low, v[k].high})
      if (a != 0 && b != 0) sum.add_product(a, b);
  for (const double a : {u[k].low, u[k].high})
    for (const double b : {v[j].low, v[j].high})
      if (a != 0 && b != 0) sum.add_product(-a, b);
  return sum.rounded();
}

}  // namespace

glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a, v = c - a;
  glm::dvec3 normal(0.0);
  bool is_sure = true;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double one = u[j] * v[k], other = u[k] * v[j];
    normal[i] = one - other;
    is_sure = is_sure && std::abs(normal[i]) >= much_cancelled * (std::abs(one) + std::abs(other));
  }
  if (is_sure) return normal;
  const exact::Difference3 exact_u = exact::difference(b, a), exact_v = exact::difference(c, a);
  for (int i = 0; i < 3; ++i)
    normal[i] =
        exact_component(exact_u, exact_v, static_cast<std::size_t>((i + 1) % 3), static_cast<std::size_t>((i + 2) % 3));
  return normal;
}

double six_volumes_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const glm::dvec3 u = b - a, v = c - a, w = d - a;
  double sum = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double one = v[j] * w[k], other = v[k] * w[j];
    sum += u[i] * (one - other);
    size += std::abs(u[i]) * (std::abs(one) + std::abs(other));
  }
  if (std::abs(sum) >= much_cancelled * size) return sum;
  return exact::determinant(exact::difference(b, a), exact::difference(c, a), exact::difference(d, a)).rounded();
}

std::string in_short(double value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.9g", value);
  return number;
}

}  // namespace ryosen::hull
