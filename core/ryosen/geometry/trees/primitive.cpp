#include "ryosen/geometry/trees/primitive.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace ryosen {

namespace {

NearestPlace nearest_on_segment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point) {
  const glm::dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec3 place = t == 1.0 ? b : a + t * along;
  return {glm::distance(place, point), place, {1.0 - t, t, 0.0}};
}

// The foot of the perpendicular if it lies inside, else the nearest point on the sides. Rounding turns the normal of a
// thin triangle, so that its foot is compared with the sides.
NearestPlace nearest_on_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                 const glm::dvec3& point) {
  constexpr double thin = 1e-12;  // a square of twice the area, as a share of the longest side's fourth power
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double area2 = glm::dot(normal, normal);
  NearestPlace best{std::numeric_limits<double>::infinity()};
  if (area2 > 0.0) {
    const double u = glm::dot(glm::cross(c - b, point - b), normal) / area2;
    const double v = glm::dot(glm::cross(a - c, point - c), normal) / area2;
    const double w = 1.0 - u - v;
    if (u >= 0.0 && v >= 0.0 && w >= 0.0) {
      const glm::dvec3 place = u * a + v * b + w * c;
      best = {glm::distance(place, point), place, {u, v, w}};
      const double longest2 = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
      if (area2 > thin * longest2 * longest2) return best;
    }
  }
  const auto add = [&](const NearestPlace& side, const glm::dvec3& barycentric) {
    if (side.distance < best.distance) best = {side.distance, side.place, barycentric};
  };
  const NearestPlace ab = nearest_on_segment(a, b, point), bc = nearest_on_segment(b, c, point),
                     ca = nearest_on_segment(c, a, point);
  add(ab, ab.barycentric);
  add(bc, {0.0, bc.barycentric.x, bc.barycentric.y});
  add(ca, {ca.barycentric.y, 0.0, ca.barycentric.x});
  return best;
}

}  // namespace

NearestPlace nearest_place(std::span<const glm::dvec3> positions, const Primitive& primitive, const glm::dvec3& point) {
  const glm::dvec3& a = positions[primitive.vertices[0]];
  switch (primitive.size()) {
    case 1:
      return {glm::distance(a, point), a, {1.0, 0.0, 0.0}};
    case 2:
      return nearest_on_segment(a, positions[primitive.vertices[1]], point);
    default:
      return nearest_on_triangle(a, positions[primitive.vertices[1]], positions[primitive.vertices[2]], point);
  }
}

}  // namespace ryosen
