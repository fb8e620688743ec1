// Welding of corners at equal positions, for formats that store coordinates per corner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/io/place_table.h"

namespace ryosen {

// Numbers distinct positions in order of first occurrence. -0 equals 0, and a position with a NaN equals none, not even
// itself; the first corner gives the coordinates. O(1) expected per corner.
class Welder {
 public:
  // Positions are added to `positions`, which must outlive the welder and be empty.
  Welder(std::vector<glm::dvec3>& positions, std::size_t expected_corners)
      : positions_(positions), table_(expected_corners) {
    positions_.reserve(expected_corners / 6);
  }

  // The number of a position.
  std::uint32_t number(const glm::dvec3& p) {
    const auto next = static_cast<std::uint32_t>(positions_.size());
    const std::uint32_t first =
        p == p ? table_.first(hash_of_place(p), next, [&](std::uint32_t stored) { return positions_[stored] == p; })
               : next;
    if (first == next) positions_.push_back(p);
    return first;
  }

 private:
  std::vector<glm::dvec3>& positions_;
  PlaceTable table_;
};

}  // namespace ryosen
