// Lists of numbers as runs of successive ones.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ryosen {

// Calls write(first, count) for runs that cover the numbers; small gaps are included.
template <class Write>
void for_runs(std::vector<std::uint32_t> numbers, const Write& write) {
  constexpr std::uint32_t small_gap = 64;
  if (!std::is_sorted(numbers.begin(), numbers.end())) std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < numbers.size();) {
    const std::uint32_t first = numbers[i];
    std::uint32_t last = first;
    while (i < numbers.size() && numbers[i] - last <= small_gap) last = numbers[i++];
    write(first, last - first + 1);
  }
}

}  // namespace ryosen
