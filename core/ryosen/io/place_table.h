// A hash table by position, for finding coincident points.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ryosen/base/column_memory.h"
#include "ryosen/geometry/place_keys.h"

namespace ryosen {

// An open-addressing table of item numbers: the first item at each position. O(1) expected; 8 bytes per slot, load
// factor at most 2/3.
class PlaceTable {
 public:
  // A mesh has about a sixth as many vertices as corners.
  explicit PlaceTable(std::size_t expected_corners) {
    std::size_t size = 64;
    while (size < expected_corners / 4) size *= 2;
    slots_.assign(size, empty);
  }

  // The item stored at a position; if there is none, stores and returns `number`. is_here(n) tells whether a stored
  // item with the same hash is really at that position.
  template <class IsHere>
  std::uint32_t first(std::uint32_t hash, std::uint32_t number, IsHere is_here) {
    if (stored_ * 3 >= slots_.size() * 2) grow();
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
      const std::uint64_t slot = slots_[at];
      if (slot == empty) {
        slots_[at] = std::uint64_t{hash} << 32 | number;
        ++stored_;
        return number;
      }
      const auto stored = static_cast<std::uint32_t>(slot);
      if (slot >> 32 == hash && is_here(stored)) return stored;
    }
  }

  // Prefetches the slot that first() will probe for this hash.
  void prefetch(std::uint32_t hash) const { __builtin_prefetch(&slots_[hash & (slots_.size() - 1)]); }

 private:
  // A slot holds the hash in its upper half and the number in the lower.
  static constexpr std::uint64_t empty = ~std::uint64_t{0};

  void grow() {
    UnwrittenVector<std::uint64_t> old(2 * slots_.size(), empty);
    old.swap(slots_);
    const std::size_t mask = slots_.size() - 1;
    for (const std::uint64_t slot : old) {
      if (slot == empty) continue;
      std::size_t at = (slot >> 32) & mask;
      while (slots_[at] != empty) at = (at + 1) & mask;
      slots_[at] = slot;
    }
  }

  UnwrittenVector<std::uint64_t> slots_;  // size is a power of two
  std::size_t stored_ = 0;
};

}  // namespace ryosen
