// SIMD intersection count of two short lists of vertex numbers.
#pragma once

#include <cstdint>
#include <cstring>

namespace ryosen {

// Block size in which the second list is read.
inline constexpr std::uint32_t ring_block = 8;

// The number of pairs of equal numbers among the first `a_count` of a and the first `b_count` of b. b must be padded to
// a whole block with numbers that are not in a.
inline std::uint32_t count_common(const std::uint32_t* a, std::uint32_t a_count, const std::uint32_t* b,
                                  std::uint32_t b_count) {
#if defined(__GNUC__)
  // Four numbers in one register; portable vector extension.
  using Four = std::uint32_t __attribute__((vector_size(16)));
  Four found{};
  for (std::uint32_t k = 0; k < b_count; k += ring_block) {
    Four low, high;
    std::memcpy(&low, b + k, sizeof low);
    std::memcpy(&high, b + k + 4, sizeof high);
    for (std::uint32_t i = 0; i < a_count; ++i) {
      const Four number{a[i], a[i], a[i], a[i]};
      found -= reinterpret_cast<Four>(low == number) + reinterpret_cast<Four>(high == number);
    }
  }
  return found[0] + found[1] + found[2] + found[3];
#else
  std::uint32_t found = 0;
  for (std::uint32_t i = 0; i < a_count; ++i)
    for (std::uint32_t k = 0; k < b_count; ++k) found += a[i] == b[k];
  return found;
#endif
}

}  // namespace ryosen
