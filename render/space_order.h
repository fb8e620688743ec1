// An order of points in which neighbours in the list are neighbours in space.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ryosen {

// The numbers of the points in the order of a Hilbert curve through their box; equal places keep their order. Linear.
std::vector<std::uint32_t> space_order(std::span<const glm::vec3> points);

}  // namespace ryosen
