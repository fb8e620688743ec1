#include "core/base/parallel.h"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <numeric>
#include <stdexcept>

namespace ryosen {
namespace {

TEST(parallel, each_part_is_done_once_and_they_meet) {
  for (const unsigned parts : {1u, 2u, 5u, 16u, 40u}) {
    std::vector<unsigned> times(1000, 0);
    std::vector<unsigned> calls(parts, 0);
    for_each_part(1000, parts, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
      ++calls[t];
      for (std::uint32_t i = begin; i < end; ++i) ++times[i];
    });
    EXPECT_EQ(times, std::vector<unsigned>(1000, 1)) << parts;
    EXPECT_EQ(calls, std::vector<unsigned>(parts, 1)) << parts;
  }
}

TEST(parallel, an_empty_range_has_its_parts_and_no_tasks_are_no_calls) {
  std::atomic<unsigned> calls = 0;
  for_each_part(0, 2, [&](unsigned, std::uint32_t begin, std::uint32_t end) { calls += begin == end; });
  EXPECT_EQ(calls, 2u);
  for_each_task(0, 4, [&](unsigned) { ++calls; });
  EXPECT_EQ(calls, 2u);
}

TEST(parallel, a_task_may_have_tasks_of_its_own) {
  std::atomic<unsigned> sum = 0;
  for_each_task(8, 3, [&](unsigned i) { for_each_task(50, 3, [&](unsigned k) { sum += 50 * i + k; }); });
  EXPECT_EQ(sum, 400u * 399u / 2u);
}

TEST(parallel, many_threads_may_ask_at_once) {
  std::vector<std::uint64_t> sums(6, 0);
  std::vector<std::thread> threads;
  for (std::uint64_t& sum : sums)
    threads.emplace_back([&sum] {
      for (int turn = 0; turn < 200; ++turn) {
        std::vector<std::uint64_t> parts(4, 0);
        for_each_part(1000, 4, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
          for (std::uint32_t i = begin; i < end; ++i) parts[t] += i;
        });
        sum += std::accumulate(parts.begin(), parts.end(), std::uint64_t{0});
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(sums, std::vector<std::uint64_t>(6, std::uint64_t{200} * 1000 * 999 / 2));
}

TEST(parallel, a_forked_process_does_it_all_alone) {
  const auto sum = [] {
    std::vector<std::uint64_t> parts(4, 0);
    for_each_part(100000, 4, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) parts[t] += i;
    });
    return std::accumulate(parts.begin(), parts.end(), std::uint64_t{0});
  };
  const std::uint64_t expected = sum();
  for (int turn = 0; turn < 20; ++turn) {
    const pid_t child = fork();
    if (child == 0) _exit(sum() == expected && sum() == expected ? 0 : 1);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(sum(), expected);
  }
}

TEST(parallel, what_is_thrown_arrives_after_all_else_is_done) {
  std::atomic<unsigned> done = 0;
  const auto work = [&](unsigned i) {
    if (i == 3) throw std::runtime_error("three");
    ++done;
  };
  EXPECT_THROW(for_each_task(20, 2, work), std::runtime_error);
  EXPECT_EQ(done, 19u);
}

}  // namespace
}  // namespace ryosen
