// Finds the corners that lie at the same place, for formats that give every corner its own coordinates.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/handle.h"

namespace ryosen {

// Numbers places in the order in which they come first. Places are equal as numbers: -0 is 0, and one with a NaN equals
// none, not even itself; the first corner at a place gives its coordinates. A flat table, O(1) per corner.
template <class Real>
class Welder {
 public:
  using Place = glm::vec<3, Real>;

  // Positions are added to `positions`, which must outlive the welder and be empty.
  Welder(std::vector<glm::dvec3>& positions, std::size_t expected_corners) : positions_(positions) {
    std::size_t size = 64;
    while (size < expected_corners / 4) size *= 2;
    slots_.assign(size, empty);
    positions_.reserve(expected_corners / 6);
  }

  // The numbers of `count` places. Those of a few hundred at once are found faster than one by one.
  void number(const Place* places, std::size_t count, std::uint32_t* numbers) {
    for (std::size_t first = 0; first < count; first += block) {
      const std::size_t n = count - first < block ? count - first : block;
      std::uint32_t hashes[block];
      for (std::size_t i = 0; i < n; ++i) {
        hashes[i] = hash(places[first + i]);
        __builtin_prefetch(&slots_[hashes[i] & (slots_.size() - 1)]);
      }
      for (std::size_t i = 0; i < n; ++i) numbers[first + i] = find(places[first + i], hashes[i]);
    }
  }

 private:
  static constexpr std::uint64_t empty = ~std::uint64_t{0};
  static constexpr std::size_t block = 48;

  static std::uint64_t bits(Real value) {
    value += Real(0);  // -0 becomes 0
    if constexpr (sizeof(Real) == 4)
      return std::bit_cast<std::uint32_t>(value);
    else
      return std::bit_cast<std::uint64_t>(value);
  }

  static std::uint32_t hash(const Place& p) {
    std::uint64_t h = bits(p.x) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32) ^ bits(p.y)) * 0xd6e8feb86659fd93u;
    h = (h ^ (h >> 32) ^ bits(p.z)) * 0xa0761d6478bd642fu;
    return static_cast<std::uint32_t>(h >> 32);
  }

  // A slot holds the hash of a place in its upper half and its number in the lower.
  std::uint32_t find(const Place& place, std::uint32_t hashed) {
    const glm::dvec3 p(place);
    if (p != p) return add(p);
    if (stored_ * 3 >= slots_.size() * 2) grow();
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hashed & mask;; at = (at + 1) & mask) {
      const std::uint64_t slot = slots_[at];
      if (slot == empty) {
        slots_[at] = std::uint64_t{hashed} << 32 | positions_.size();
        ++stored_;
        return add(p);
      }
      const auto number = static_cast<std::uint32_t>(slot);
      if (slot >> 32 == hashed && positions_[number] == p) return number;
    }
  }

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
