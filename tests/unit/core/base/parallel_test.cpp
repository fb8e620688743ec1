#include "ryosen/base/parallel.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <vector>

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

TEST(parallel, what_is_thrown_arrives_and_no_further_task_begins) {
  std::atomic<unsigned> done = 0;
  const auto work = [&](unsigned i) {
    if (i == 3) throw std::runtime_error("three");
    if (i > 3) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ++done;
  };
  EXPECT_THROW(for_each_task(20, 2, work), std::runtime_error);
  EXPECT_LT(done, 19u);
  done = 0;
  EXPECT_THROW(for_each_task(20, 1, work), std::runtime_error);
  EXPECT_EQ(done, 3u) << "what follows may use what was left half done";
}

TEST(parallel, what_is_done_here_stays_on_its_thread_whatever_goes_on_beside_it) {
  for (int turn = 0; turn < 50; ++turn) {
    std::thread::id here;
    std::atomic<unsigned> sum = 0;
    do_beside([&] { here = std::this_thread::get_id(); }, [&] { for_each_task(10, 2, [&](unsigned i) { sum += i; }); });
    EXPECT_EQ(here, std::this_thread::get_id());
    EXPECT_EQ(sum, 45u);
  }
}

TEST(parallel, here_and_beside_it_go_on_at_the_same_time) {
  std::atomic<int> begun = 0;
  const auto meets_the_other = [&] {
    ++begun;
    for (int i = 0; i < 10000 && begun < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(begun, 2);
  };
  do_beside(meets_the_other, meets_the_other);
}

TEST(parallel, what_either_side_throws_arrives_when_both_are_done) {
  std::atomic<unsigned> done = 0;
  const auto work = [&] { ++done; };
  const auto fails = [] { throw std::runtime_error("here or beside"); };
  EXPECT_THROW(do_beside(fails, work), std::runtime_error);
  EXPECT_THROW(do_beside(work, fails), std::runtime_error);
  EXPECT_EQ(done, 2u);
}

}  // namespace
}  // namespace ryosen
