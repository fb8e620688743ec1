// How much the tests try. `tests/run.sh --long` sets RYOSEN_LONG and asks for the long random walks and comparisons. A
// short run sets RYOSEN_ONE_OF to a number under the sanitizers, where all is many times slower: one seed of so many is
// tried there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace ryosen::test {

inline bool is_long_run() { return std::getenv("RYOSEN_LONG") != nullptr; }

// Whether only a sample is tried, which need not meet everything.
inline bool is_sample() { return !is_long_run() && std::getenv("RYOSEN_ONE_OF"); }

// The number of seeds that this run tries of `few`, or all `many` of a long run; one at least.
inline std::uint64_t seed_count(std::uint64_t few, std::uint64_t many) {
  if (is_long_run()) return many;
  const char* one_of = std::getenv("RYOSEN_ONE_OF");
  const std::uint64_t part = one_of ? std::strtoull(one_of, nullptr, 10) : 1;
  return std::max<std::uint64_t>(few / std::max<std::uint64_t>(part, 1), 1);
}
inline std::uint64_t seed_count(std::uint64_t few) { return seed_count(few, few); }

}  // namespace ryosen::test
