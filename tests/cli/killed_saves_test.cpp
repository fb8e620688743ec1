// The program killed at a random moment of a conversion leaves the whole old or the whole new file. Its own part of
// that time, the save, is aimed at more closely in tests/unit/core/io/killed_save_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>

#include "tests/support/app/process.h"
#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

TEST(killed_saves, the_program_leaves_the_whole_old_or_the_whole_new_file) {
  const test::TemporaryFolder inputs, outputs;
  const std::string bunny = test::read_file(test::asset("stanford_bunny.obj")), out = outputs.at("out.ply");
  const std::vector<std::string> meshes{inputs.write("a.obj", bunny), inputs.write("b.obj", bunny + "v 9 9 9\n")};
  const auto words = [&](std::size_t mesh) {
    return std::vector<std::string>{RYOSEN_PROGRAM, "convert", meshes[mesh], "-o", out, "-q"};
  };
  std::vector<std::string> contents;
  std::vector<Seconds> times;
  for (int i = 0; i < 6; ++i) {
    const Clock::time_point start = Clock::now();
    ASSERT_EQ(test::Process(words(static_cast<std::size_t>(i % 2))).wait(), 0);
    times.push_back(Clock::now() - start);
    contents.push_back(test::read_file(out));
  }
  ASSERT_NE(contents[0], contents[1]);
  std::sort(times.begin(), times.end());
  const Seconds typical = times[times.size() / 2];

  const unsigned seed = std::random_device()();
  std::mt19937 random(seed);
  const int kills = test::is_long_run() ? 40 : 16;
  int old_stayed = 0, new_came = 0;
  std::size_t now = 1;
  for (int i = 0; i < kills; ++i) {
    const std::size_t next = 1 - now;
    outputs.write("out.ply", contents[now]);
    const double share = (i + std::uniform_real_distribution<>(0, 1)(random)) / kills;
    test::Process saving(words(next));
    std::this_thread::sleep_for((0.5 + 0.9 * share) * typical);  // reading comes first
    saving.end_by(SIGKILL);
    const std::string found = test::read_file(out);
    old_stayed += found == contents[now];
    new_came += found == contents[next];
    ASSERT_EQ(old_stayed + new_came, i + 1) << "neither the old nor the new file; seed " << seed << ", round " << i;
    now = next;
  }
  std::printf("%d kills between %.1f and %.1f ms, seed %u: %d times the old file, %d times the new\n", kills,
              500 * typical.count(), 1400 * typical.count(), seed, old_stayed, new_came);
  EXPECT_EQ(old_stayed + new_came, kills);
  ASSERT_EQ(test::Process(words(0)).wait(), 0);
  EXPECT_EQ(outputs.names(), std::vector<std::string>{"out.ply"}) << "the next save clears what the kills left";
}

}  // namespace
}  // namespace ryosen
