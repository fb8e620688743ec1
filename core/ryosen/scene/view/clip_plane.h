// A plane that cuts a view of a mesh: what lies beyond it is neither seen nor picked.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "ryosen/geometry/ray.h"

namespace ryosen {

// The axis across which a mesh is cut, and which way what is cut off lies; view: across the line of sight, what is
// nearer.
enum class ClipWay { off, x, minus_x, y, minus_y, z, minus_z, view };

struct ClipPlane {
  glm::dvec3 normal{0, 0, 1};  // of length 1, towards what is cut off
  double offset = 0;           // of the plane along it
  friend bool operator==(const ClipPlane&, const ClipPlane&) = default;

  // How far beyond the plane a place lies; what is on it is kept.
  double beyond(const glm::dvec3& place) const { return glm::dot(normal, place) - offset; }
  bool cuts(const glm::dvec3& place) const { return beyond(place) > 0; }
};

// The part of a ray that is kept; hits nothing where there is none.
Ray kept(const Ray& ray, const std::optional<ClipPlane>& plane);

// The first and the last point of the segment from a to b that are kept, as parameters from 0 at a to 1 at b; none
// where all of it is cut off.
struct KeptPart {
  double first, last;
};
std::optional<KeptPart> kept(const glm::dvec3& a, const glm::dvec3& b, const std::optional<ClipPlane>& plane);

}  // namespace ryosen
