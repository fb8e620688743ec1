// Finds the corners that lie at the same place, for formats that give every corner its own coordinates.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/handle.h"

namespace ryosen {

// A hash of a place, the same for 0 and -0. Each of its bits depends on all coordinates.
template <class Real>
std::uint32_t hash_of_place(const glm::vec<3, Real>& place) {
  const auto bits = [](Real value) -> std::uint64_t {
    value += Real(0);  // -0 becomes 0
    if constexpr (sizeof(Real) == 4)
      return std::bit_cast<std::uint32_t>(value);
    else
      return std::bit_cast<std::uint64_t>(value);
  };
  std::uint64_t h = bits(place.x) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 32) ^ bits(place.y)) * 0xd6e8feb86659fd93u;
  h = (h ^ (h >> 32) ^ bits(place.z)) * 0xa0761d6478bd642fu;
  return static_cast<std::uint32_t>(h >> 32);
}

// Numbers places in the order in which they come first. Places are equal as numbers: -0 is 0, and one with a NaN equals
// none, not even itself; the first corner at a place gives its coordinates. A flat table, O(1) per corner.
class Welder {
 public:
  // Positions are added to `positions`, which must outlive the welder and be empty.
  Welder(std::vector<glm::dvec3>& positions, std::size_t expected_corners) : positions_(positions) {
    std::size_t size = 64;
    while (size < expected_corners / 4) size *= 2;
    slots_.assign(size, empty);
    positions_.reserve(expected_corners / 6);
  }

  // The number of a place.
  std::uint32_t number(const glm::dvec3& p) {
    if (p != p) return add(p);
    if (stored_ * 3 >= slots_.size() * 2) grow();
    const std::uint32_t hashed = hash_of_place(p);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hashed & mask;; at = (at + 1) & mask) {
      const std::uint64_t slot = slots_[at];
      if (slot == empty) {
        slots_[at] = std::uint64_t{hashed} << 32 | positions_.size();
        ++stored_;
        return add(p);
      }
      const auto stored = static_cast<std::uint32_t>(slot);
      if (slot >> 32 == hashed && positions_[stored] == p) return stored;
    }
  }

 private:
  // A slot holds the hash of a place in its upper half and its number in the lower.
  static constexpr std::uint64_t empty = ~std::uint64_t{0};

  std::uint32_t add(const glm::dvec3& p) {
    positions_.push_back(p);
    return static_cast<std::uint32_t>(positions_.size() - 1);
  }

  void grow() {
    std::vector<std::uint64_t> old(2 * slots_.size(), empty);
    old.swap(slots_);
    const std::size_t mask = slots_.size() - 1;
    for (const std::uint64_t slot : old) {
      if (slot == empty) continue;
      std::size_t at = (slot >> 32) & mask;
      while (slots_[at] != empty) at = (at + 1) & mask;
      slots_[at] = slot;
    }
  }

  std::vector<glm::dvec3>& positions_;
  std::vector<std::uint64_t> slots_;  // a power of two
  std::size_t stored_ = 0;
};

}  // namespace ryosen
