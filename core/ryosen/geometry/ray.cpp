#include "ryosen/geometry/ray.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ryosen/geometry/is_finite.h"

namespace ryosen {
namespace {

// Bitwise the same sum for every order of the terms.
double sum_of(double a, double b, double c) {
  if (b < a) std::swap(a, b);
  if (c < b) std::swap(b, c);
  if (b < a) std::swap(a, b);
  return (a + b) + c;
}

}  // namespace

RayCaster::RayCaster(const Ray& ray) : origin_(ray.origin), t_min_(ray.t_min), t_max_(ray.t_max) {
  const glm::dvec3& d = ray.direction;
  if (!is_finite(d) || !is_finite(ray.origin)) return;
  z_ = std::abs(d.x) > std::abs(d.y) ? 0 : 1;
  if (std::abs(d.z) >= std::abs(d[z_])) z_ = 2;
  if (d[z_] == 0.0) return;
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  shear_x_ = d[x_] / d[z_];
  shear_y_ = d[y_] / d[z_];
  scale_z_ = 1.0 / d[z_];
  valid_ = true;
}

std::optional<TriangleHit> RayCaster::hit(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
  return hit_from_origin(a - origin_, b - origin_, c - origin_, 1.0);
}

// Corners relative to the origin, and divided by `size`.
std::optional<TriangleHit> RayCaster::hit_from_origin(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                                      double size) const {
  const double ax = a[x_] - shear_x_ * a[z_], ay = a[y_] - shear_y_ * a[z_];
  const double bx = b[x_] - shear_x_ * b[z_], by = b[y_] - shear_y_ * b[z_];
  const double cx = c[x_] - shear_x_ * c[z_], cy = c[y_] - shear_y_ * c[z_];
  // Edge functions (twice the signed areas); swapping the ends of an edge only flips the sign, exactly.
  const double u = cx * by - cy * bx;
  const double v = ax * cy - ay * cx;
  const double w = bx * ay - by * ax;
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return std::nullopt;
  const double reach = std::max({largest_magnitude(a), largest_magnitude(b), largest_magnitude(c)});
  // Products of very large or small numbers overflow or underflow: rescale to size 1 and retry.
  if (size == 1.0 && (reach > 0x1p+300 || (reach < 0x1p-200 && reach > 0.0))) {
    const double scale = std::ldexp(1.0, std::clamp(std::ilogb(reach), -1000, 1000));
    return hit_from_origin(a / scale, b / scale, c / scale, scale);
  }
  const double det = sum_of(std::abs(u), std::abs(v), std::abs(w));
  if (!(det > 0.0)) return std::nullopt;
  // For a triangle too small for its distance the signs are rounding noise; also require the ray to meet its bounding
  // box.
  const double slack = reach * 0x1p-48;
  if (std::min({ax, bx, cx}) > slack || std::max({ax, bx, cx}) < -slack || std::min({ay, by, cy}) > slack ||
      std::max({ay, by, cy}) < -slack)
    return std::nullopt;
  const glm::dvec3 weights(std::abs(u), std::abs(v), std::abs(w));
  const double depths =
      sum_of(weights.x * (scale_z_ * a[z_]), weights.y * (scale_z_ * b[z_]), weights.z * (scale_z_ * c[z_]));
  const double t = depths / det * size;
  if (!(t >= t_min_ && t <= t_max_)) return std::nullopt;
  return TriangleHit{t, weights / det};
}

}  // namespace ryosen
