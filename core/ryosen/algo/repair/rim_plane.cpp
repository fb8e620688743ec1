#include "ryosen/algo/repair/rim_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "ryosen/geometry/decimal_of_single.h"
#include "ryosen/geometry/exact_sum.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/single_precision.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

constexpr double most_units = 4;

// dot(n, p - at), rounded once: a rim far from the origin leaves its plane by less than a plain sum errs.
double height(const glm::dvec3& n, const glm::dvec3& p, const glm::dvec3& at) {
  exact::Expansion<12> sum;
  for (int axis = 0; axis < 3; ++axis) {
    sum.add_product(n[axis], p[axis]);
    sum.add_product(-n[axis], at[axis]);
  }
  return sum.rounded();
}

bool looks_single(std::span<const glm::dvec3> rim) {
  std::size_t decimals = 0;
  for (const glm::dvec3& p : rim)
    for (int axis = 0; axis < 3; ++axis) {
      if (to_single(p[axis]) == p[axis]) continue;
      if (!is_decimal_of_single(p[axis])) return false;
      ++decimals;
    }
  return decimals == 0 || 2 * decimals >= 3 * rim.size();
}

// A unit vector across n.
glm::dvec3 across(const glm::dvec3& n) {
  const glm::dvec3 a = glm::abs(n);
  const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                          : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(n, axis));
}

// The normal with its tilt against the places taken away, by least squares.
glm::dvec3 fitted(const glm::dvec3& n, std::span<const glm::dvec3> places, const glm::dvec3& at) {
  const glm::dvec3 u = across(n), v = glm::cross(n, u);
  double uu = 0, uv = 0, vv = 0, uh = 0, vh = 0;
  for (const glm::dvec3& p : places) {
    const double x = glm::dot(u, p - at), y = glm::dot(v, p - at), h = height(n, p, at);
    uu += x * x;
    uv += x * y;
    vv += y * y;
    uh += x * h;
    vh += y * h;
  }
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-12 * uu * vv)) return n;
  const double a = (uh * vv - vh * uv) / determinant, b = (vh * uu - uh * uv) / determinant;
  return glm::normalize(n - a * u - b * v);
}

}  // namespace

glm::dvec3 mean_of(std::span<const glm::dvec3> places) {
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : places) mean += p / static_cast<double>(places.size());
  return mean;
}

bool are_all_floats(std::span<const glm::dvec3> places) {
  return std::all_of(places.begin(), places.end(),
                     [](const glm::dvec3& p) { return !is_finite(p) || to_single(p) == p; });
}

std::optional<RimPlane> RimPlane::of(std::span<const glm::dvec3> rim, double largest,
                                     std::optional<bool> holds_floats) {
  if (!(largest > 0)) return std::nullopt;
  RimPlane plane;
  plane.exponent_ = std::ilogb(largest);
  const bool looks = looks_single(rim);
  plane.is_single_ = holds_floats.value_or(looks);
  plane.snaps_ = plane.is_single_ && looks;
  plane.box_ = box_of(rim);
  std::vector<glm::dvec3> places;
  for (const glm::dvec3& p : rim) places.push_back(times_power_of_two(p, -plane.exponent_));
  plane.normal_ = polygon_normal(places);
  if (plane.normal_ == glm::dvec3(0.0)) return std::nullopt;
  plane.at_ = mean_of(places);
  plane.normal_ = fitted(plane.normal_, places, plane.at_);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const glm::dvec3& p : places) {
    const double h = height(plane.normal_, p, plane.at_);
    lowest = std::min(lowest, h);
    highest = std::max(highest, h);
  }
  if (!(std::ldexp((highest - lowest) / 2, plane.exponent_) <= plane.tolerance())) return std::nullopt;
  plane.at_ += (highest + lowest) / 2 * plane.normal_;
  return plane;
}

double RimPlane::tolerance() const { return std::ldexp(most_units * (is_single_ ? 0x1p-23 : 0x1p-52), exponent_); }

double RimPlane::distance(const glm::dvec3& p) const {
  return std::ldexp(std::abs(height(normal_, times_power_of_two(p, -exponent_), at_)), exponent_);
}

glm::dvec3 RimPlane::nearest(const glm::dvec3& p) const {
  const glm::dvec3 q = times_power_of_two(p, -exponent_);
  const glm::dvec3 foot = times_power_of_two(q - height(normal_, q, at_) * normal_, exponent_);
  return glm::clamp(snaps_ ? to_single(foot) : foot, box_.lowest, box_.highest);
}

}  // namespace ryosen
