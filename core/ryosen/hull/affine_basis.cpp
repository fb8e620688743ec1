#include "ryosen/hull/affine_basis.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/exact_sum.h"
#include "ryosen/geometry/predicates.h"

namespace ryosen::hull {

namespace {

// Places relative to the first one, in halves of the largest extent, so that no product overflows.
class ScaledPlaces {
 public:
  ScaledPlaces(std::span<const glm::dvec3> points, std::uint32_t origin, double half_extent)
      : points_(points), origin_(points[origin] / 2.0), half_extent_(half_extent) {}
  glm::dvec3 operator[](std::uint32_t i) const { return (points_[i] / 2.0 - origin_) / half_extent_; }

 private:
  std::span<const glm::dvec3> points_;
  glm::dvec3 origin_;
  double half_extent_;
};

// The point with the largest value if that passes, else the first one that does; their number where none does. Values
// only choose, is_good decides.
template <class Value, class IsGood>
std::uint32_t best_of(std::uint32_t count, const Value& value, const IsGood& is_good) {
  std::uint32_t best = 0;
  double largest = -1;
  for (std::uint32_t i = 0; i < count; ++i)
    if (const double v = value(i); v > largest) {
      largest = v;
      best = i;
    }
  if (largest > 0 && is_good(best)) return best;
  for (std::uint32_t i = 0; i < count; ++i)
    if (is_good(i)) return i;
  return count;
}

// Component `axis` of the cross product of b - a and c - a as products of two coordinates.
void add_component(exact::ProductSum<2>& sum, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int axis,
                   bool negate) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const auto add = [&](const glm::dvec3& p, const glm::dvec3& q) {
    sum.add_product(p[j], q[k], negate);
    sum.add_product(p[k], q[j], !negate);
  };
  add(a, b);
  add(b, c);
  add(c, a);
}

}  // namespace

AffineBasis affine_basis(std::span<const glm::dvec3> points) {
  const auto count = static_cast<std::uint32_t>(points.size());
  AffineBasis basis;
  if (count == 0) return basis;
  basis.dimension = 0;
  double half_extent = -1;
  bool is_flat = false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [&](const glm::dvec3& p, const glm::dvec3& q) { return p[axis] < q[axis]; });
    const double half = (*high)[axis] / 2 - (*low)[axis] / 2;
    is_flat = is_flat || (*high)[axis] == (*low)[axis];
    if (!(half > half_extent)) continue;
    half_extent = half;
    basis.points[0] = static_cast<std::uint32_t>(low - points.begin());
    basis.points[1] = static_cast<std::uint32_t>(high - points.begin());
  }
  if (count == 1) return basis;
  basis.dimension = 1;
  if (!(half_extent > 0)) {  // they differ in the last bit of the smallest doubles, which the halves do not have
    basis.points = {0, 1};
    half_extent = 1;
  }
  const ScaledPlaces scaled(points, basis.points[0], half_extent);
  const glm::dvec3 &a = points[basis.points[0]], &b = points[basis.points[1]];
  const glm::dvec3 along = scaled[basis.points[1]];
  const std::uint32_t third = best_of(
      count,
      [&](std::uint32_t i) {
        const glm::dvec3 normal = glm::cross(along, scaled[i]);
        return std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
      },
      [&](std::uint32_t i) { return !are_collinear(a, b, points[i]); });
  if (third == count) return basis;
  basis.dimension = 2;
  basis.points[2] = third;
  if (is_flat) return basis;
  glm::dvec3 normal = glm::cross(along, scaled[third]);
  if (const double size = glm::length(normal); size > 0) normal /= size;
  const glm::dvec3& c = points[third];
  const std::uint32_t fourth = best_of(
      count, [&](std::uint32_t i) { return std::abs(glm::dot(normal, scaled[i])); },
      [&](std::uint32_t i) { return orient3d(a, b, c, points[i]) != 0; });
  if (fourth == count) return basis;
  basis.dimension = 3;
  basis.points[3] = fourth;
  return basis;
}

SignedAxis largest_normal_axis(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  SignedAxis largest{0, cross_component_sign(a, b, c, 0)};
  for (int axis = 1; axis < 3; ++axis) {
    const int sign = cross_component_sign(a, b, c, axis);
    if (sign == 0) continue;
    exact::ProductSum<2> difference;  // of the two magnitudes
    add_component(difference, a, b, c, axis, sign < 0);
    if (largest.sign != 0) add_component(difference, a, b, c, largest.axis, largest.sign > 0);
    if (difference.sign() > 0) largest = {axis, sign};
  }
  return largest;
}

}  // namespace ryosen::hull
