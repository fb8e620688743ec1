// Consecutive numbers for those of a range that are chosen.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/base/parallel.h"

namespace ryosen::subdivide {

// For each i below `count` how many chosen ones come before it; one more entry holds how many there are.
template <class IsChosen>
std::vector<std::uint32_t> ranks(std::uint32_t count, const IsChosen& is_chosen) {
  const unsigned parts = threads_for(count);
  std::vector<std::uint32_t> found(std::size_t{count} + 1), sums(parts + 1, 0);
  for_each_part(count, parts, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t n = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      found[i] = n;
      n += is_chosen(i) ? 1u : 0u;
    }
    sums[t + 1] = n;
  });
  for (unsigned t = 0; t < parts; ++t) sums[t + 1] += sums[t];
  for_each_part(count, parts, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; t > 0 && i < end; ++i) found[i] += sums[t];
  });
  found[count] = sums[parts];
  return found;
}

}  // namespace ryosen::subdivide
