// A triangle cut into equal ones.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace ryosen {

using TrianglePlaces = std::array<glm::dvec3, 3>;

// Point `along` of line `line`, both from 0; line 0 is the first corner, line k the side that faces it. Corners are
// exact.
inline glm::dvec3 lattice_point(const TrianglePlaces& t, std::uint32_t k, std::uint32_t line, std::uint32_t along) {
  if (line == 0) return t[0];
  if (line == k && (along == 0 || along == k)) return t[along == 0 ? 1 : 2];
  return (double(k - line) * t[0] + double(line - along) * t[1] + double(along) * t[2]) / double(k);
}

// One of the k * k similar triangles, by lines of 1, 3, 5 ... from the first corner on. k < 30000.
inline TrianglePlaces subtriangle(const TrianglePlaces& t, std::uint32_t k, std::uint32_t index) {
  if (k == 1) return t;
  auto line = static_cast<std::uint32_t>(std::sqrt(double(index)));
  while (line * line > index) --line;
  while ((line + 1) * (line + 1) <= index) ++line;
  const std::uint32_t place = index - line * line, along = place / 2;
  if (place % 2 == 0)
    return {lattice_point(t, k, line, along), lattice_point(t, k, line + 1, along),
            lattice_point(t, k, line + 1, along + 1)};
  return {lattice_point(t, k, line, along), lattice_point(t, k, line + 1, along + 1),
          lattice_point(t, k, line, along + 1)};
}

}  // namespace ryosen
