// Spatial sorting of points along a Hilbert curve.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen {

// The indices of the points in Hilbert curve order within their bounding box; stable. Linear (radix sort).
std::vector<std::uint32_t> hilbert_order(std::span<const glm::vec3> points);

}  // namespace ryosen
