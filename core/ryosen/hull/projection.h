// Points seen along an axis: their shadow in a plane through the origin.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace ryosen {

// best: along the axis in which the points reach least, the first of equal ones.
enum class Projection : std::uint8_t { none, x, y, z, best };

struct ProjectionRow {
  Projection projection;
  std::string_view id, en, ja;
};
// In the order of the enum.
std::span<const ProjectionRow> projections();
// Null for an unknown id.
const ProjectionRow* find_projection(std::string_view id);

// The same points with 0 for their coordinate on the axis: exact. Points that are not finite stay as they are.
void project(std::vector<glm::dvec3>& points, Projection projection);

}  // namespace ryosen
