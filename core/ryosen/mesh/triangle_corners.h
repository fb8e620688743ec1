// The places of the corners of a triangle, and its normal.
#pragma once

#include <array>
#include <glm/geometric.hpp>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

using TriangleCorners = std::array<glm::dvec3, 3>;

// From the start of a halfedge on, which lies in a triangle.
[[gnu::always_inline]] inline TriangleCorners corners_of(const Mesh& mesh, Halfedge h) {
  return {mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.from(mesh.prev(h)))};
}
// Twice the area along the normal.
[[gnu::always_inline]] inline glm::dvec3 area_normal(const TriangleCorners& c) {
  return glm::cross(c[1] - c[0], c[2] - c[0]);
}

}  // namespace ryosen
