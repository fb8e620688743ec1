// Measures of hulls: places of points in a unit in which nothing overflows and only what is far below the others
// underflows, products of their differences, and numbers within sentences.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>

namespace ryosen::hull {

// In units of a power of two, below 1 in magnitude: exact but for what underflows.
class UnitPlaces {
 public:
  // Of the points with these numbers.
  UnitPlaces(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers) : points_(points) {
    glm::dvec3 largest(0.0);
    for (const std::uint32_t i : numbers) largest = glm::max(largest, glm::abs(points[i]));
    for (int axis = 0; axis < 3; ++axis)
      if (largest[axis] > 0) std::frexp(largest[axis], &exponents_[static_cast<std::size_t>(axis)]);
    if (const double most = std::max({largest.x, largest.y, largest.z}); most > 0) std::frexp(most, &exponent_);
  }
  glm::dvec3 operator[](std::uint32_t i) const {
    const glm::dvec3& p = points_[i];
    if (exponent_ == 0) return p;
    return {std::ldexp(p.x, -exponent_), std::ldexp(p.y, -exponent_), std::ldexp(p.z, -exponent_)};
  }
  // That in units of each axis of its own.
  glm::dvec3 by_axis(std::uint32_t i) const {
    glm::dvec3 p = points_[i];
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], -exponents_[static_cast<std::size_t>(axis)]);
    return p;
  }
  // A volume of these in units of the points.
  double full_volume(double value) const { return std::ldexp(value, exponents_[0] + exponents_[1] + exponents_[2]); }
  // A number of so many dimensions in units of the points.
  double full(double value, int dimensions) const { return std::ldexp(value, dimensions * exponent_); }

 private:
  std::span<const glm::dvec3> points_;
  int exponent_ = 0;
  std::array<int, 3> exponents_{};
};

// Products of differences of places below 1 in magnitude, right to nearly the last bit also where what is multiplied
// nearly cancels. What falls below the smallest doubles is lost. Cost: a few nanoseconds, where the terms nearly cancel
// a few microseconds.
glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);  // (b - a) x (c - a)
// (b - a) x (c - a) . (d - a)
double six_volumes_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

// A number within a sentence.
std::string in_short(double value);

}  // namespace ryosen::hull
