// Values of corners as formats hold them that know one per vertex.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/indexed/indexed.h"

namespace ryosen {

// The place in the pool for each vertex if all corners of a vertex have the same value; none if some differ, if corners
// lack a value, or if no vertex has one. A vertex without a face takes the entry of its own number when the pool has
// one entry per vertex, as readers of values per vertex make it. O(corners).
std::optional<std::vector<std::uint32_t>> per_vertex(const IndexedMesh& mesh, const CornerValues& values);

// The value of a pool; zeros for no_index.
glm::dvec3 value_of(const CornerValues& values, std::uint32_t index);

}  // namespace ryosen
