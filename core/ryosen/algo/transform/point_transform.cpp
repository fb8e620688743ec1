#include "ryosen/algo/transform/point_transform.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

struct Turn {
  double cosine, sine;
};

// Exact at quarters, so that four of them are none.
Turn turn_by(double degrees) {
  const double rest = std::remainder(degrees, 360.0);
  if (rest == 0) return {1, 0};
  if (rest == 90) return {0, 1};
  if (rest == -90) return {0, -1};
  if (std::abs(rest) == 180) return {-1, 0};
  const double angle = rest * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

// About a unit axis through the origin.
glm::dvec3 turned(const glm::dvec3& p, const glm::dvec3& axis, const Turn& turn) {
  return turn.cosine * p + turn.sine * glm::cross(axis, p) + (1 - turn.cosine) * glm::dot(axis, p) * axis;
}

// Scaled by 0: exactly at the centre, or at its height along an axis of coordinates.
glm::dvec3 flattened(glm::dvec3 place, const glm::dvec3& about, const std::optional<glm::dvec3>& axis) {
  if (!axis) return about;
  for (int i = 0; i < 3; ++i) {
    if (std::abs((*axis)[i]) != 1) continue;
    place[i] = about[i];
    return place;
  }
  return place - glm::dot(*axis, place - about) * *axis;
}

}  // namespace

glm::dvec3 PointTransform::operator()(const glm::dvec3& place, double share) const {
  const glm::dvec3 from_centre = place - about;
  switch (kind) {
    case Kind::move:
      return place + share * by;
    case Kind::turn:
      return about + turned(from_centre, axis.value_or(glm::dvec3(0, 0, 1)), turn_by(share * angle_deg));
    case Kind::scale: {
      const double grown = share * (factor - 1);
      if (grown == -1) return flattened(place, about, axis);
      return place + grown * (axis ? glm::dot(*axis, from_centre) * *axis : from_centre);
    }
  }
  return place;
}

std::optional<glm::dvec3> direction_of(const glm::dvec3& vector) {
  if (!is_finite(vector)) return std::nullopt;
  const glm::dvec3 unit = unit_vector(vector);
  return is_finite(unit) && glm::length(unit) > 0.5 ? std::optional(unit) : std::nullopt;
}

}  // namespace ryosen
