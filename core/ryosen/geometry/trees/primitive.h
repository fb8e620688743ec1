// The primitives of a bounding volume hierarchy: a triangle, a segment or a point, given by vertex numbers. The nearest
// point on each.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "ryosen/base/handle.h"
#include "ryosen/geometry/box.h"

namespace ryosen {

// `owner` is set by the caller: the face of a triangle, the edge of a segment, the vertex of a point.
struct Primitive {
  std::array<std::uint32_t, 3> vertices{no_index, no_index, no_index};
  std::uint32_t owner = no_index;

  static Primitive triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) {
    return {{a, b, c}, face};
  }
  static Primitive segment(std::uint32_t a, std::uint32_t b, std::uint32_t edge) { return {{a, b, no_index}, edge}; }
  static Primitive point(std::uint32_t vertex) { return {{vertex, no_index, no_index}, vertex}; }

  // Number of vertices, 0 for an empty primitive.
  int size() const {
    if (vertices[0] == no_index) return 0;
    if (vertices[1] == no_index) return 1;
    return vertices[2] == no_index ? 2 : 3;
  }
};

// Exact.
inline Box box_of(std::span<const glm::dvec3> positions, const Primitive& primitive) {
  // Missing vertices are replaced by the first one, so the common case has no branches.
  const std::array<std::uint32_t, 3>& v = primitive.vertices;
  const glm::dvec3& a = positions[v[0]];
  const glm::dvec3& b = positions[v[1] == no_index ? v[0] : v[1]];
  const glm::dvec3& c = positions[v[2] == no_index ? v[0] : v[2]];
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

// The nearest point on a primitive.
struct NearestPlace {
  double distance = 0.0;
  glm::dvec3 place{0.0};
  glm::dvec3 barycentric{0.0};  // weights of the vertices; those a primitive does not have are 0
};

// O(1). Degenerate triangles count as their longest side. The primitive has at least one vertex.
NearestPlace nearest_place(std::span<const glm::dvec3> positions, const Primitive& primitive, const glm::dvec3& point);

}  // namespace ryosen
