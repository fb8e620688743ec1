#include "ryosen/geometry/surely_apart.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

using Triangle = std::array<glm::dvec3, 3>;

// More than what rounds off, in units of the lengths that were added.
constexpr double margin = 1e-12;

glm::dvec3 sizes_of(const Triangle& t) { return glm::max(glm::max(glm::abs(t[0]), glm::abs(t[1])), glm::abs(t[2])); }

bool separates(const glm::dvec3& axis, const Triangle& a, const Triangle& b, const glm::dvec3& reach) {
  const auto along = [&](const glm::dvec3& p) { return glm::dot(axis, p); };
  const auto [low_a, high_a] = std::minmax({along(a[0]), along(a[1]), along(a[2])});
  const auto [low_b, high_b] = std::minmax({along(b[0]), along(b[1]), along(b[2])});
  const double wide = margin * glm::dot(glm::abs(axis), reach);
  return high_a + wide < low_b || high_b + wide < low_a;
}

}  // namespace

bool are_surely_apart(const Triangle& triangle, const Box& box) {
  if (!box.overlaps(box_of(triangle))) return true;
  const glm::dvec3 middle = box.middle(), half = 0.5 * (box.highest - box.lowest);
  const Triangle v{triangle[0] - middle, triangle[1] - middle, triangle[2] - middle};
  const glm::dvec3 reach = sizes_of(v) + half;
  const auto is_apart_along = [&](const glm::dvec3& axis) {
    const double a = glm::dot(axis, v[0]), b = glm::dot(axis, v[1]), c = glm::dot(axis, v[2]);
    const double wide = glm::dot(glm::abs(axis), half) + margin * glm::dot(glm::abs(axis), reach);
    return std::min({a, b, c}) > wide || std::max({a, b, c}) < -wide;
  };
  const Triangle sides{v[1] - v[0], v[2] - v[1], v[0] - v[2]};
  for (const glm::dvec3& e : sides)
    if (is_apart_along({0, -e.z, e.y}) || is_apart_along({e.z, 0, -e.x}) || is_apart_along({-e.y, e.x, 0})) return true;
  return is_apart_along(glm::cross(sides[0], sides[1]));
}

bool are_surely_apart(const Triangle& a, const Triangle& b) {
  const glm::dvec3 origin = a[0];
  const Triangle u{a[0] - origin, a[1] - origin, a[2] - origin}, v{b[0] - origin, b[1] - origin, b[2] - origin};
  const glm::dvec3 reach = glm::max(sizes_of(u), sizes_of(v));
  for (const Triangle* t : {&u, &v}) {
    const Triangle sides{(*t)[1] - (*t)[0], (*t)[2] - (*t)[1], (*t)[0] - (*t)[2]};
    const glm::dvec3 normal = glm::cross(sides[0], sides[1]);
    if (separates(normal, u, v, reach)) return true;
    for (const glm::dvec3& side : sides)
      if (separates(glm::cross(normal, side), u, v, reach)) return true;
  }
  return false;
}

}  // namespace ryosen
