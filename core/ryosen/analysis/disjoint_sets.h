// Union-find over the numbers 0 to n-1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ryosen/base/interruption.h"

namespace ryosen {

// The smallest number of a set is its root. Amortised cost per call: O(log n), nearly constant in practice.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n = 0) { reset(n); }
  // Resets to n singletons; keeps the memory.
  void reset(std::size_t n) {
    parent_.clear();
    resize_in_steps(parent_, n);
    for (std::uint32_t i = 0; i < n; ++i) {
      stop_if_interrupted(i);
      parent_[i] = i;
    }
    count_ = static_cast<std::uint32_t>(n);
  }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  // Returns whether they were in different sets.
  bool join(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    if (i == j) return false;
    if (j < i) std::swap(i, j);
    parent_[j] = i;
    --count_;
    return true;
  }
  // Number of sets, singletons included.
  std::uint32_t count() const { return count_; }

 private:
  std::vector<std::uint32_t> parent_;
  std::uint32_t count_ = 0;
};

}  // namespace ryosen
