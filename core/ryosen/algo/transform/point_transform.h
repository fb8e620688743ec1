// Moving, turning and scaling points, whole or by a share.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace ryosen {

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
