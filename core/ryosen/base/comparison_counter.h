// What code that is measured counts its comparisons with: nothing where its time is taken, each where its work is.
#pragma once

#include <cstdint>

namespace ryosen {

struct NotCounted {
  static constexpr void count() {}
};

struct Counted {
  std::uint64_t comparisons = 0;
  void count() { ++comparisons; }
};

}  // namespace ryosen
