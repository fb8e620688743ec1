#include "ryosen/geometry/locate.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

bool lies_on(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  if (orient2d(a, b, p) != 0) return false;
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

}  // namespace

int view_axis(const glm::dvec3& normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (z >= x && z >= y) return 2;
  return y >= x ? 1 : 0;
}

Place locate(const glm::dvec3& p, std::span<const glm::dvec3> polygon, int axis) {
  const glm::dvec2 q = seen_along(p, axis);
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = seen_along(polygon[i], axis), b = seen_along(polygon[(i + 1) % polygon.size()], axis);
    if (lies_on(q, a, b)) return Place::on;
    if ((a.y > q.y) == (b.y > q.y)) continue;
    const int side = orient2d(a, b, q);
    if ((side > 0) == (b.y > a.y)) is_inside = !is_inside;  // the side crosses the ray to the right of q
  }
  return is_inside ? Place::inside : Place::outside;
}

double projected_area(std::span<const glm::dvec3> polygon, const glm::dvec3& normal) {
  return 2 * glm::dot(vector_area(polygon), normal);
}

}  // namespace ryosen
