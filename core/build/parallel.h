// Work on parts of a range, one thread per part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

namespace ryosen {

// How many threads pay for so many steps: one for small work, otherwise up to two.
inline unsigned threads_for(std::size_t steps) {
  constexpr std::size_t worth_a_thread = 100000;
  return steps >= worth_a_thread && std::thread::hardware_concurrency() > 1 ? 2 : 1;
}

// Where part t of `parts` begins in a range of `count`.
inline std::uint32_t part_begin(std::uint32_t count, unsigned t, unsigned parts) {
  return static_cast<std::uint32_t>(std::uint64_t{count} * t / parts);
}

// Calls work(t, begin, end) for each part at the same time, or in turn where the system has no thread to give. The work
// must not throw.
template <class Work>
void for_each_part(std::uint32_t count, unsigned parts, const Work& work) {
  std::vector<std::thread> others;
  others.reserve(parts - 1);
  for (unsigned t = 1; t < parts; ++t) {
    const auto do_part = [&, t] { work(t, part_begin(count, t, parts), part_begin(count, t + 1, parts)); };
    try {
      others.emplace_back(do_part);
    } catch (const std::system_error&) {
      do_part();
    }
  }
  work(0, 0, part_begin(count, 1, parts));
  for (std::thread& other : others) other.join();
}

}  // namespace ryosen
