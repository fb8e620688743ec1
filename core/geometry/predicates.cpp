#include "core/geometry/predicates.h"

#include <cmath>
#include <limits>

#include "core/geometry/exact_sum.h"
#include "core/geometry/is_finite.h"

namespace ryosen {
namespace {

// Magnitudes for which differences, products and their last bits all stay inside the range of normal doubles.
constexpr double smallest_safe = 0x1p-400;
constexpr double largest_safe = 0x1p+400;

bool is_safe(double value) {
  const double size = std::abs(value);
  return value == 0.0 || (size >= smallest_safe && size <= largest_safe);
}

bool is_safe(const glm::dvec2& p) { return is_safe(p.x) && is_safe(p.y); }
// The determinant as six products; those of c.x with c.y cancel.
int orient2d_by_accumulator(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return 0;
  exact::ProductAccumulator sum;
  sum.add_product(a.x, b.y, false);
  sum.add_product(a.x, c.y, true);
  sum.add_product(c.x, b.y, true);
  sum.add_product(a.y, b.x, true);
  sum.add_product(a.y, c.x, false);
  sum.add_product(c.y, b.x, false);
  return sum.sign();
}

int orient2d_by_expansion(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const exact::Pair acx = exact::two_sum(a.x, -c.x);
  const exact::Pair acy = exact::two_sum(a.y, -c.y);
  const exact::Pair bcx = exact::two_sum(b.x, -c.x);
  const exact::Pair bcy = exact::two_sum(b.y, -c.y);
  exact::Expansion<16> sum;
  sum.add_product(acx.high, bcy.high);
  sum.add_product(-acy.high, bcx.high);
  if (acx.low != 0.0 || acy.low != 0.0 || bcx.low != 0.0 || bcy.low != 0.0) {
    sum.add_product(acx.high, bcy.low);
    sum.add_product(acx.low, bcy.high);
    sum.add_product(acx.low, bcy.low);
    sum.add_product(-acy.high, bcx.low);
    sum.add_product(-acy.low, bcx.high);
    sum.add_product(-acy.low, bcx.low);
  }
  return sum.sign();
}

glm::dvec2 without_axis(const glm::dvec3& p, int axis) {
  if (axis == 0) return {p.y, p.z};
  if (axis == 1) return {p.z, p.x};
  return {p.x, p.y};
}

template <class Point>
bool all_collinear(std::size_t count, Point&& point) {
  std::size_t second = 1;
  while (second < count && point(second) == point(0)) ++second;
  for (std::size_t i = second + 1; i < count; ++i) {
    if (!are_collinear(point(0), point(second), point(i))) return false;
  }
  return true;
}

}  // namespace

int orient2d(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double size = std::abs(left) + std::abs(right);
  // Above the lower limit an underflowed product is far below the error bound; beyond the upper one, or with a NaN,
  // a difference or product overflowed. The bound is that of [Shewchuk97], (3 + 16 u) u, with room to spare.
  if (size > 1e-280 && size <= std::numeric_limits<double>::max() && std::abs(det) > 4e-16 * size) {
    return det > 0.0 ? 1 : -1;
  }
  if (is_safe(a) && is_safe(b) && is_safe(c)) return orient2d_by_expansion(a, b, c);
  return orient2d_by_accumulator(a, b, c);
}

int cross_component_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int axis) {
  return orient2d(without_axis(a, axis), without_axis(b, axis), without_axis(c, axis));
}

bool are_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return cross_component_sign(a, b, c, 2) == 0 && cross_component_sign(a, b, c, 0) == 0 &&
         cross_component_sign(a, b, c, 1) == 0;
}

bool are_collinear(std::span<const glm::dvec3> points) {
  return all_collinear(points.size(), [&](std::size_t i) -> const glm::dvec3& { return points[i]; });
}

bool are_collinear(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> corners) {
  return all_collinear(corners.size(), [&](std::size_t i) -> const glm::dvec3& { return positions[corners[i]]; });
}

}  // namespace ryosen
