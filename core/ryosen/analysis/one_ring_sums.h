// Sums over the neighbours of all vertices at once, as smoothing and the umbrella operator [Taubin95] need them.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// sums[v] becomes the sum of values[w] over neighbours(mesh, v), in unspecified order. Zero for isolated and dead
// vertices. Both have vertex_slots() entries and must not overlap. Iterates over edges instead of circulating around
// vertices: no dependent loads and no branch misprediction at the end of each ring. O(vertices + edges), no allocation.
void one_ring_sums(const Mesh& mesh, std::span<const glm::dvec3> values, std::span<glm::dvec3> sums);

}  // namespace ryosen
