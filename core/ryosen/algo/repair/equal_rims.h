// Rims of holes that are congruent, so that they are filled alike.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/algo/repair/hole_loop.h"

namespace ryosen {

// Corner i of this rim is corner shift + i of rim `as`, or shift - i where one is the mirror image of the other.
struct EqualRim {
  std::uint32_t as = 0, shift = 0;
  bool is_mirrored = false;

  std::uint32_t corner_of(std::uint32_t i, std::uint32_t size) const {
    return is_mirrored ? (shift + size - i) % size : (shift + i) % size;
  }
};

// Finds for each rim an earlier one that it equals but for `rounding` and a millionth part of its size or so; none
// where there is none, and for rims of collinear corners. O(n log n); of symmetrical rims a few turns are tried.
std::vector<std::optional<EqualRim>> find_equal_rims(std::span<const std::vector<glm::dvec3>> rims, double rounding);

// The patch of the rim `equal.as`, moved to the hole: as many vertices and triangles in the same arrangement.
HolePatch patch_like(const HolePatch& other, const EqualRim& equal, const HoleLoop& hole);

}  // namespace ryosen
