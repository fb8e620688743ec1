// The places of points in a unit in which nothing overflows and only what is far below the others underflows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace ryosen::hull {

// In units of a power of two, below 1 in magnitude: exact but for what underflows.
class UnitPlaces {
 public:
  // Of the points with these numbers.
  UnitPlaces(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers) : points_(points) {
    double largest = 0;
    for (const std::uint32_t i : numbers)
      largest = std::max({largest, std::abs(points[i].x), std::abs(points[i].y), std::abs(points[i].z)});
    if (largest > 0) std::frexp(largest, &exponent_);
  }
  glm::dvec3 operator[](std::uint32_t i) const {
    const glm::dvec3& p = points_[i];
    if (exponent_ == 0) return p;
    return {std::ldexp(p.x, -exponent_), std::ldexp(p.y, -exponent_), std::ldexp(p.z, -exponent_)};
  }
  // A number of so many dimensions in units of the points.
  double full(double value, int dimensions) const { return std::ldexp(value, dimensions * exponent_); }

 private:
  std::span<const glm::dvec3> points_;
  int exponent_ = 0;
};

}  // namespace ryosen::hull
