// Lengths and directions of vectors, robust against overflow and underflow of the squares.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ryosen {

// The exponent such that 2^-exponent brings the vector to about unit size.
inline int exponent_of(const glm::dvec3& v) {
  int exponent = 0;
  std::frexp(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), &exponent);
  return exponent;
}

// The vector times 2^exponent: exact, but for numbers too large or too small.
inline glm::dvec3 times_power_of_two(const glm::dvec3& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

inline double length_of(const glm::dvec3& vector) {
  const int exponent = exponent_of(vector);
  return std::ldexp(glm::length(times_power_of_two(vector, -exponent)), exponent);
}

inline glm::dvec3 unit_vector(const glm::dvec3& vector) {
  return glm::normalize(times_power_of_two(vector, -exponent_of(vector)));
}

// The same of vectors whose squares neither overflow nor underflow; 0 of one whose length is 0.
inline glm::dvec3 unit_or_zero(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0 ? vector / length : glm::dvec3(0.0);
}

}  // namespace ryosen
