#include "ryosen/geometry/trees/primitive.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

NearestPlace nearest_on_segment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point) {
  const glm::dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec3 place = t == 1.0 ? b : a + t * along;
  return {glm::distance(place, point), place, {1.0 - t, t, 0.0}};
}

// The foot of the perpendicular if it lies inside, else the nearest point on the sides.
NearestPlace nearest_on_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                 const glm::dvec3& point) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double area2 = glm::dot(normal, normal);
  if (area2 > 0.0) {
    const double u = glm::dot(glm::cross(c - b, point - b), normal) / area2;
    const double v = glm::dot(glm::cross(a - c, point - c), normal) / area2;
    const double w = 1.0 - u - v;
    if (u >= 0.0 && v >= 0.0 && w >= 0.0) {
      const glm::dvec3 place = u * a + v * b + w * c;
      return {glm::distance(place, point), place, {u, v, w}};
    }
  }
  NearestPlace best = nearest_on_segment(a, b, point);
  NearestPlace other = nearest_on_segment(b, c, point);
  other.barycentric = {0.0, other.barycentric.x, other.barycentric.y};
  if (other.distance < best.distance) best = other;
  other = nearest_on_segment(c, a, point);
  other.barycentric = {other.barycentric.y, 0.0, other.barycentric.x};
  if (other.distance < best.distance) best = other;
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
