// Corner values for formats that store one value per vertex.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ryosen/indexed/indexed.h"

namespace ryosen {

// The pool index for each vertex, if all corners of each vertex have the same value; none if some differ, if corners
// lack a value, or if no vertex has one. An isolated vertex gets the entry with its own number if the pool has one
// entry per vertex, as readers of per-vertex values produce. O(corners).
std::optional<std::vector<std::uint32_t>> per_vertex(const IndexedMesh& mesh, const CornerValues& values);

// The value of a pool; zeros for no_index.
glm::dvec3 value_of(const CornerValues& values, std::uint32_t index);

}  // namespace ryosen
