// The set of cells that an open transaction has recorded already: an open-addressing hash set that is cleared in O(1).
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/mesh/columns.h"

namespace ryosen {

class CellMarks {
 public:
  // O(1), except for a full reset once per 2^24 calls.
  void clear() {
    count_ = 0;
    if (++generation_ == generation_end) forget();
  }

  // Inserts the cell; true if it was not in the set. O(1) expected.
  bool insert(Column column, std::uint32_t index) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    const std::uint64_t key = generation_ << key_bits | std::uint64_t{static_cast<std::uint8_t>(column)} << 32 | index;
    std::size_t slot = first_slot(key);
    while (slots_[slot] >> key_bits == generation_) {
      if (slots_[slot] == key) return false;
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = key;
    ++count_;
    return true;
  }

 private:
  static constexpr unsigned key_bits = 40;  // column and index; the generation is in the bits above
  static constexpr std::uint64_t generation_end = std::uint64_t{1} << (64 - key_bits);

  std::size_t first_slot(std::uint64_t key) const {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15ull;
    return static_cast<std::size_t>((key * odd) >> 32) & (slots_.size() - 1);
  }
  void forget() {
    slots_.assign(slots_.size(), 0);
    generation_ = 1;
  }
  void grow();

  std::vector<std::uint64_t> slots_;  // size is a power of two; entries of an older generation are free
  std::uint64_t generation_ = 1;
  std::size_t count_ = 0;
};

}  // namespace ryosen
