// Spatial sorting of points along a Hilbert curve.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>

#include "core/mesh/column_memory.h"

namespace ryosen {

// The numbers of points in Hilbert curve order within their bounding box; stable. point(i) gives a place, always the same
// one, and is asked twice for each of `count`, from several threads where there are many. Linear (radix sort).
UnwrittenVector<std::uint32_t> hilbert_order(std::uint32_t count, const std::function<glm::vec3(std::uint32_t)>& point);

}  // namespace ryosen
