// Sums over the neighbours of all vertices at once, as smoothing and the umbrella operator [Taubin95] need them.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/mesh/mesh.h"

namespace ryosen {

// sums[v] becomes the sum of values[w] over the neighbours w of v: over what neighbours(mesh, v) gives, in an order of
// its own. Zero for isolated and dead vertices. Both have vertex_slots() entries and do not overlap. Runs over the edges
// instead of around the vertices: no step waits for the one before, and none has to guess where a ring ends.
// O(vertices + edges), no memory. For programs that use the library; this one has no use for it.
void one_ring_sums(const Mesh& mesh, std::span<const glm::dvec3> values, std::span<glm::dvec3> sums);

}  // namespace ryosen
