// Rays and the ray-triangle test.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

namespace ryosen {

inline double largest_magnitude(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The points origin + t * direction with t_min <= t <= t_max. The direction need not have unit length; t is in units of
// its length. A zero or non-finite direction hits nothing.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};
  double t_min = 0.0;
  double t_max = std::numeric_limits<double>::infinity();
};

// Where a ray meets a triangle. The barycentric weights are in [0, 1] and sum to 1 up to rounding.
struct TriangleHit {
  double t = 0.0;
  glm::dvec3 barycentric{0.0};
};

// A ray prepared for many triangles [Woop13], in double precision: watertight (no ray passes between two triangles that
// share an edge), and t is bitwise independent of the order of a triangle's corners.
class RayCaster {
 public:
  explicit RayCaster(const Ray& ray);

  // False for a zero direction, or a non-finite direction or origin.
  bool is_valid() const { return valid_; }

  // No back-face culling. Degenerate triangles and those seen edge-on are not hit.
  std::optional<TriangleHit> hit(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;

 private:
  std::optional<TriangleHit> hit_from_origin(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                             double size) const;

  glm::dvec3 origin_;
  int x_ = 0, y_ = 1, z_ = 2;  // axes, z_ the one along which the direction is largest
  double shear_x_ = 0.0, shear_y_ = 0.0, scale_z_ = 1.0;
  double t_min_ = 0.0, t_max_ = 0.0;
  bool valid_ = false;
};

}  // namespace ryosen
