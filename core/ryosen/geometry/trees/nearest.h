// The nearest point on a triangle, segment or point primitive.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "ryosen/geometry/trees/primitive.h"

namespace ryosen {

struct NearestPlace {
  double distance = 0.0;
  glm::dvec3 place{0.0};
  glm::dvec3 barycentric{0.0};  // weights of the vertices; those a primitive does not have are 0
};

// O(1). Degenerate triangles count as their longest side. The primitive has at least one vertex.
NearestPlace nearest_place(std::span<const glm::dvec3> positions, const Primitive& primitive, const glm::dvec3& point);

}  // namespace ryosen
