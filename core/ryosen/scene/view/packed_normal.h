// Unit vectors in 32 bits: on an octahedron that is unfolded into a square, 16 bits for each side of it. Off by less
// than 0.01 degrees. Shaders unpack them (shaders/light.glsl).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace ryosen {

// No direction.
inline constexpr std::uint32_t no_normal = 0;

namespace detail {

inline double sign_of(double x) { return x < 0 ? -1 : 1; }

}  // namespace detail

// Of any length; that without a direction is no_normal.
inline std::uint32_t packed_normal(const glm::dvec3& v) {
  const double size = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  if (!(size > 0) || !std::isfinite(size)) return no_normal;
  double x = v.x / size, y = v.y / size;
  if (v.z < 0) {
    const double folded = (1 - std::abs(y)) * detail::sign_of(x);
    y = (1 - std::abs(x)) * detail::sign_of(y);
    x = folded;
  }
  // From 1 on: zero is no direction.
  const auto bits = [](double side) { return static_cast<std::uint32_t>(std::lround((side + 1) * 32767)) + 1; };
  return bits(x) | (bits(y) << 16);
}

inline glm::dvec3 unpacked_normal(std::uint32_t packed) {
  if (packed == no_normal) return glm::dvec3(0);
  double x = static_cast<double>(packed & 0xffffu) - 32768, y = static_cast<double>(packed >> 16) - 32768;
  x /= 32767;
  y /= 32767;
  const double z = 1 - std::abs(x) - std::abs(y);
  const double fold = std::max(-z, 0.0);
  x -= detail::sign_of(x) * fold;
  y -= detail::sign_of(y) * fold;
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

}  // namespace ryosen
