// Numbers in the order of a cost, as far as it matters: costs between two powers of two share a few levels, and within
// a level the first to come is the first to go. Adding and taking cost O(1).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace ryosen {

class LevelQueue {
 public:
  using Level = std::uint32_t;

  // 2^bits levels from one power of two to the next.
  explicit LevelQueue(unsigned bits)
      : shift_(52 - bits), first_(key_of(smallest)), levels_(key_of(largest) - first_ + 1) {}

  // Of a cost from 0 up; what is no number counts as the largest.
  Level level_of(double cost) const {
    if (!(cost <= largest)) return static_cast<Level>(levels_.size() - 1);
    return static_cast<Level>(key_of(std::max(cost, smallest)) - first_);
  }

  // Puts it on its level, or on the one that is being taken from where that is already past.
  void add(std::uint32_t number, Level level) { levels_[std::max(level, current_)].push_back(number); }

  // Goes to the next number; false where there is none, and everything added from then on is taken from the lowest
  // level again.
  bool next() {
    ++place_;
    while (place_ >= levels_[current_].size()) {
      std::vector<std::uint32_t>().swap(levels_[current_]);
      place_ = 0;
      if (current_ + 1 == levels_.size()) {
        restart();
        return false;
      }
      ++current_;
    }
    return true;
  }
  // The same, but no further than the end of the level.
  bool next_on_level() {
    if (place_ + 1 >= levels_[current_].size()) return false;
    ++place_;
    return true;
  }
  std::uint32_t number() const { return levels_[current_][place_]; }
  // The number so many steps ahead on the same level, or the last one.
  std::uint32_t ahead(std::size_t steps) const {
    const std::vector<std::uint32_t>& level = levels_[current_];
    return level[std::min(place_ + steps, level.size() - 1)];
  }
  Level current() const { return current_; }

 private:
  static constexpr double smallest = 0x1p-120, largest = 0x1p40;

  void restart() {
    current_ = 0;
    place_ = static_cast<std::size_t>(-1);
  }
  std::uint64_t key_of(double cost) const { return std::bit_cast<std::uint64_t>(cost) >> shift_; }

  unsigned shift_;
  std::uint64_t first_;
  std::vector<std::vector<std::uint32_t>> levels_;
  Level current_ = 0;
  std::size_t place_ = static_cast<std::size_t>(-1);
};

}  // namespace ryosen
