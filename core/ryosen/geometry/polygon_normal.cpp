#include "ryosen/geometry/polygon_normal.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ryosen {
namespace {

double largest_component(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Twice the vector area of the polygon after multiplication by `scale`, a power of two.
struct ScaledSum {
  glm::dvec3 twice_area{0.0};
  int exponent = 0;  // the polygon is 2^exponent times as large as the one summed
};

int exponent_of(double size) { return std::clamp(std::ilogb(size), -1000, 1000); }

ScaledSum newell_sum(std::span<const glm::dvec3> polygon) {
  ScaledSum result;
  if (polygon.size() < 3) return result;
  // Halve the coordinates if differences could overflow.
  const glm::dvec3 origin = polygon[0];
  double largest = 0.0;
  for (const glm::dvec3& p : polygon) largest = std::max(largest, largest_component(p));
  const double halving = largest > 0x1p+1022 ? 0.5 : 1.0;
  double reach = 0.0;
  for (const glm::dvec3& p : polygon) reach = std::max(reach, largest_component(p * halving - origin * halving));
  if (reach == 0.0) return result;
  const int exponent = exponent_of(reach);
  const double scale = std::ldexp(1.0, -exponent);
  glm::dvec3 before = (polygon[1] * halving - origin * halving) * scale;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const glm::dvec3 here = (polygon[i] * halving - origin * halving) * scale;
    result.twice_area += glm::cross(before, here);
    before = here;
  }
  result.exponent = exponent + (halving < 1.0 ? 1 : 0);
  return result;
}

}  // namespace

glm::dvec3 vector_area(std::span<const glm::dvec3> polygon) {
  const ScaledSum sum = newell_sum(polygon);
  const int exponent = 2 * sum.exponent - 1;
  return {std::ldexp(sum.twice_area.x, exponent), std::ldexp(sum.twice_area.y, exponent),
          std::ldexp(sum.twice_area.z, exponent)};
}

double polygon_area(std::span<const glm::dvec3> polygon) {
  const ScaledSum sum = newell_sum(polygon);
  return std::ldexp(glm::length(sum.twice_area), 2 * sum.exponent - 1);
}

glm::dvec3 polygon_normal(std::span<const glm::dvec3> polygon) {
  const glm::dvec3 sum = newell_sum(polygon).twice_area;
  const double size = largest_component(sum);
  if (size == 0.0) return glm::dvec3(0.0);
  const double scale = std::ldexp(1.0, -exponent_of(size));
  return glm::normalize(sum * scale);
}

double polygon_volume(std::span<const glm::dvec3> polygon, const glm::dvec3& apex) {
  if (polygon.size() < 3) return 0.0;
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : polygon) mean += (p - apex) / static_cast<double>(polygon.size());
  return glm::dot(vector_area(polygon), mean) / 3.0;
}

}  // namespace ryosen
