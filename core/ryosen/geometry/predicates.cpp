#include "ryosen/geometry/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/geometry/exact_sum.h"
#include "ryosen/geometry/is_finite.h"

namespace ryosen {

namespace {

// Whether differences, products of two or three factors and their rounding errors all stay in the range of normal
// doubles.
template <int factors>
bool is_safe(double value) {
  constexpr double largest = factors == 2 ? 0x1p+400 : 0x1p+250;
  const double size = std::abs(value);
  return value == 0.0 || (size >= 1 / largest && size <= largest);
}
bool is_safe(const glm::dvec2& p) { return is_safe<2>(p.x) && is_safe<2>(p.y); }
bool is_safe(const glm::dvec3& p) { return is_safe<3>(p.x) && is_safe<3>(p.y) && is_safe<3>(p.z); }
bool is_safe(const Difference& u) { return is_safe(u.from) && is_safe(u.to); }
bool is_finite_difference(const Difference& u) { return is_finite(u.from) && is_finite(u.to); }

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

int determinant_by_accumulator(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  exact::ProductSum<3> sum;
  exact::add_determinant_from(sum, a, b, c, d);
  return sum.sign();
}

// Of three differences, expanded into eight determinants.
int determinant_by_accumulator(const Difference& u, const Difference& v, const Difference& w) {
  exact::ProductSum<3> sum;
  for (const bool a : {false, true})
    for (const bool b : {false, true})
      for (const bool c : {false, true})
        exact::add_determinant(sum, a ? u.from : u.to, b ? v.from : v.to, c ? w.from : w.to, (a != b) != c);
  return sum.sign();
}

// The determinant of three rows where rounding cannot have changed its sign, else 0. The bound is that of [Shewchuk97],
// (7 + 56 u) u, with room to spare. The limits keep underflow errors (smallest double times a difference, each) far
// below the bound and exclude overflow (a NaN fails all comparisons).
int sure_determinant_sign(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w) {
  const double vw_x = v.y * w.z, wv_x = v.z * w.y, vw_y = v.z * w.x, wv_y = v.x * w.z, vw_z = v.x * w.y,
               wv_z = v.y * w.x;
  const double det = u.x * (vw_x - wv_x) + u.y * (vw_y - wv_y) + u.z * (vw_z - wv_z);
  const double size = std::abs(u.x) * (std::abs(vw_x) + std::abs(wv_x)) +
                      std::abs(u.y) * (std::abs(vw_y) + std::abs(wv_y)) +
                      std::abs(u.z) * (std::abs(vw_z) + std::abs(wv_z));
  const double reach = std::abs(u.x) + std::abs(u.y) + std::abs(u.z);
  if (size > 1e-200 && size <= 1e+300 && reach < 1e+100 && std::abs(det) > 8e-16 * size) return det > 0.0 ? 1 : -1;
  return 0;
}

// Adds the square of the length of a difference, or subtracts it.
void add_square(exact::ProductAccumulator& sum, const Difference& u, bool negate) {
  for (int axis = 0; axis < 3; ++axis) {
    sum.add_product(u.to[axis], u.to[axis], negate);
    sum.add_product(u.from[axis], u.from[axis], negate);
    for (int twice = 0; twice < 2; ++twice) sum.add_product(u.to[axis], u.from[axis], !negate);
  }
}

template <class Point>
bool all_collinear(std::size_t count, Point&& point) {
  std::size_t second = 1;
  while (second < count && point(second) == point(0)) ++second;
  for (std::size_t i = second + 1; i < count; ++i)
    if (!are_collinear(point(0), point(second), point(i))) return false;
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
  if (size > 1e-280 && size <= std::numeric_limits<double>::max() && std::abs(det) > 4e-16 * size)
    return det > 0.0 ? 1 : -1;
  if (is_safe(a) && is_safe(b) && is_safe(c)) return orient2d_by_expansion(a, b, c);
  return orient2d_by_accumulator(a, b, c);
}

int orient3d(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  if (const int sign = sure_determinant_sign(a - d, b - d, c - d)) return -sign;
  if (is_safe(a) && is_safe(b) && is_safe(c) && is_safe(d))
    return -exact::determinant(exact::difference(a, d), exact::difference(b, d), exact::difference(c, d)).sign();
  if (!is_finite(a) || !is_finite(b) || !is_finite(c) || !is_finite(d)) return 0;
  return -determinant_by_accumulator(a, b, c, d);
}

int determinant_sign(const Difference& u, const Difference& v, const Difference& w) {
  if (const int sign = sure_determinant_sign(u.to - u.from, v.to - v.from, w.to - w.from)) return sign;
  if (is_safe(u) && is_safe(v) && is_safe(w))
    return exact::determinant(exact::difference(u.to, u.from), exact::difference(v.to, v.from),
                              exact::difference(w.to, w.from))
        .sign();
  if (!is_finite_difference(u) || !is_finite_difference(v) || !is_finite_difference(w)) return 0;
  return determinant_by_accumulator(u, v, w);
}

int compare_lengths(const Difference& u, const Difference& v) {
  const auto square = [](const glm::dvec3& d) { return d.x * d.x + d.y * d.y + d.z * d.z; };
  const double a = square(u.to - u.from), b = square(v.to - v.from), larger = std::max(a, b);
  if (larger > 1e-280 && larger <= std::numeric_limits<double>::max() && std::abs(a - b) > 2e-15 * larger)
    return a > b ? 1 : -1;
  if (!is_finite_difference(u) || !is_finite_difference(v)) return 0;
  exact::ProductAccumulator sum;
  add_square(sum, u, false);
  add_square(sum, v, true);
  return sum.sign();
}

int cross_component_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int axis) {
  return orient2d(seen_along(a, axis), seen_along(b, axis), seen_along(c, axis));
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

int AroundEdge::turn(const glm::dvec3& one, const glm::dvec3& other) const {
  return determinant_sign({start_, end_}, {start_, one}, {start_, other});
}

int AroundEdge::part_of(const glm::dvec3& through) const {
  if (const int sign = turn(first_, through)) return sign > 0 ? 1 : 3;
  for (int axis = 0; axis < 3; ++axis)
    if (const int sign = cross_component_sign(start_, end_, first_, axis))
      return sign == cross_component_sign(start_, end_, through, axis) ? 0 : 2;
  return 0;
}

int AroundEdge::compare(const glm::dvec3& one, const glm::dvec3& other) const {
  const int part = part_of(one), other_part = part_of(other);
  if (part != other_part) return part < other_part ? -1 : 1;
  return part == 0 || part == 2 ? 0 : -turn(one, other);
}

}  // namespace ryosen
