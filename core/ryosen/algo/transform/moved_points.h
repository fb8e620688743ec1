// Moving, turning and scaling points, whole or by a share: which points, by what share, and to where.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct MovedPoint {
  Vertex point;      // stands for all its copies
  double share = 1;  // of the transform
};

// The points of elements, ascending, each once.
std::vector<Vertex> points_of(const Mesh& mesh, std::span<const Element> elements);

// Points that are moved whole, and with a radius all others nearer to one of them than that, by a share that falls off
// smoothly with the distance: 1 at none, 0 at the radius. Ascending. Without a radius it costs the points, else it is
// O(n) and what is tried: points in neighbouring cells of a grid as wide as the radius.
std::vector<MovedPoint> moved_points(const Mesh& mesh, std::span<const Vertex> whole, double falloff_radius);

// Their mean; the origin of none.
glm::dvec3 middle_of(const Mesh& mesh, std::span<const Vertex> points);

// By value. A share of 1 is all of it, 0 nothing; of a turn it is a turn by that share of the angle.
struct PointTransform {
  enum class Kind { move, turn, scale };
  Kind kind = Kind::move;
  glm::dvec3 by{0};                // of a move
  double angle_deg = 0;            // of a turn, counter-clockwise seen against the axis
  double factor = 1;               // of a scaling; negative mirrors too
  std::optional<glm::dvec3> axis;  // unit vector: of a turn, else +Z; scales along it alone, else everywhere
  glm::dvec3 about{0};             // stays where it is when turned or scaled

  glm::dvec3 operator()(const glm::dvec3& place, double share = 1) const;
};

// Along a direction of any length but none; none where it has none or is not finite.
std::optional<glm::dvec3> direction_of(const glm::dvec3& vector);

}  // namespace ryosen
