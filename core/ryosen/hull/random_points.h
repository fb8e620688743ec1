// Families of random points to try hulls on: the same for the same seed on every machine.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace ryosen {

enum class PointFamily : std::uint8_t { ball, sphere, cube, grid, cospherical, lattice };

struct PointFamilyRow {
  PointFamily family;
  std::string_view id, en, ja;
};
// In the order of the enum.
std::span<const PointFamilyRow> point_families();

// So many points within 1 of the origin along each axis.
// ball: evenly within it. sphere: evenly on it, but for rounding. cube: evenly within it. grid: all points of a regular
// one, the first of them in order. cospherical: on a sphere about the origin, exactly; its radius is 0.97. lattice: of
// a grid with about as many points, each by chance, so that many lie in one plane and some at one place. Cost:
// O(count); cospherical ones take some microseconds each.
std::vector<glm::dvec3> random_points(PointFamily family, std::size_t count, std::uint64_t seed);

}  // namespace ryosen
