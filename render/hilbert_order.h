// Spatial sorting of points along a Hilbert curve.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "render/screen.h"
#include "ryosen/base/column_memory.h"

namespace ryosen {

// Writes the points from the number `first` on; asked from several threads where there are many.
using ReadPoints = std::function<void(std::uint32_t first, std::span<glm::vec3> points)>;

// The numbers of `count` points in the order of a Hilbert curve through the box; stable. Each is asked for once. One
// outside the box counts as the nearest one inside. Linear (radix sort).
UnwrittenVector<std::uint32_t> hilbert_order(std::uint32_t count, const DrawBox& box, const ReadPoints& read);

}  // namespace ryosen
