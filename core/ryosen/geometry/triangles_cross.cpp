#include "ryosen/geometry/triangles_cross.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

using Triangle = std::array<glm::dvec3, 3>;

// orient3d in floating point; 0 if the rounding error could exceed the value.
int certain_side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const glm::dvec3 u = a - d, v = b - d, w = c - d;
  const double value = glm::dot(u, glm::cross(v, w));
  const double size = std::abs(u.x) * (std::abs(v.y * w.z) + std::abs(v.z * w.y)) +
                      std::abs(u.y) * (std::abs(v.z * w.x) + std::abs(v.x * w.z)) +
                      std::abs(u.z) * (std::abs(v.x * w.y) + std::abs(v.y * w.x));
  constexpr double relative_error = 1e-15;
  if (!(std::abs(value) > relative_error * size)) return 0;
  return value > 0 ? 1 : -1;
}

bool passes_through(const glm::dvec3& p, const glm::dvec3& q, const Triangle& t) {
  const int side_p = certain_side(t[0], t[1], t[2], p), side_q = certain_side(t[0], t[1], t[2], q);
  if (side_p * side_q != -1) return false;
  const int first = certain_side(p, q, t[0], t[1]);
  return first != 0 && first == certain_side(p, q, t[1], t[2]) && first == certain_side(p, q, t[2], t[0]);
}

}  // namespace

bool triangles_cross(const Triangle& a, const Triangle& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (passes_through(a[k], a[(k + 1) % 3], b) || passes_through(b[k], b[(k + 1) % 3], a)) return true;
  return false;
}

}  // namespace ryosen
