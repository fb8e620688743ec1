#include "ryosen/geometry/surely_apart.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

using Triangle = std::array<glm::dvec3, 3>;

// More than what rounds off, in units of the lengths that were added.
constexpr double margin = 1e-12;

glm::dvec3 sizes_of(const Triangle& t) { return glm::max(glm::max(glm::abs(t[0]), glm::abs(t[1])), glm::abs(t[2])); }

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

TriangleSlabs::TriangleSlabs(const Triangle& t) : origin_(t[0]) {
  const glm::dvec3 b = t[1] - origin_, c = t[2] - origin_, normal = glm::cross(b, c);
  reach_ = glm::max(glm::abs(b), glm::abs(c));
  const std::array axes{normal, glm::cross(normal, b), glm::cross(normal, c - b), glm::cross(normal, c)};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double at_b = glm::dot(axes[i], b), at_c = glm::dot(axes[i], c);
    slabs_[i] = {axes[i], std::min({0.0, at_b, at_c}), std::max({0.0, at_b, at_c})};
  }
}

bool TriangleSlabs::separate(const Triangle& other) const {
  const Triangle v{other[0] - origin_, other[1] - origin_, other[2] - origin_};
  const glm::dvec3 reach = glm::max(reach_, sizes_of(v));
  for (const Slab& slab : slabs_) {
    const double a = glm::dot(slab.axis, v[0]), b = glm::dot(slab.axis, v[1]), c = glm::dot(slab.axis, v[2]);
    const double wide = margin * glm::dot(glm::abs(slab.axis), reach);
    if (std::min(std::min(a, b), c) > slab.high + wide || std::max(std::max(a, b), c) < slab.low - wide) return true;
  }
  return false;
}

}  // namespace ryosen
