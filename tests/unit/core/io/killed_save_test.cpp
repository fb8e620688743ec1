// A process killed at a random moment of a save leaves the whole old or the whole new file.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>
#include <vector>

#include "tests/support/core/long_run.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// A net of n x n squares at a height, so that two heights give two files of about the same length.
MeshFile net(std::uint32_t n, double height) {
  MeshFile file;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) file.mesh.positions.push_back({i, j, height});
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i;
      file.mesh.corners.insert(file.mesh.corners.end(), {a, a + 1, a + n + 2, a + n + 1});
      file.mesh.face_offsets.push_back(static_cast<std::uint32_t>(file.mesh.corners.size()));
    }
  }
  return file;
}

// Saves in a process of its own, which says when it begins. Killed after a while; else it ends by itself.
struct SavingProcess {
  SavingProcess(const std::filesystem::path& path, const MeshFile& file) {
    int ends[2];
    if (::pipe(ends) != 0) return;
    id = ::fork();
    if (id == 0) {
      const char begun = 1;
      if (::write(ends[1], &begun, 1) != 1) ::_exit(2);
      ::_exit(write_mesh_file(path, file).ok() ? 0 : 1);
    }
    char begun = 0;
    EXPECT_EQ(::read(ends[0], &begun, 1), 1);
    for (const int end : ends) ::close(end);
  }
  int wait() const {
    int status = 0;
    ::waitpid(id, &status, 0);
    return status;
  }

  pid_t id = -1;
};

void wait_for(Seconds time) {
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
  if (time > Seconds(0.002)) std::this_thread::sleep_for(time - Seconds(0.001));
  while (Clock::now() < end) {
  }
}

TEST(killed_save, leaves_the_whole_old_or_the_whole_new_file) {
  // Beside this program lies a disk; writing into memory is over too soon to be met.
  const io_test::TemporaryFolder folder(std::filesystem::read_symlink("/proc/self/exe").parent_path());
  const std::filesystem::path path = folder / "net.obj";
  const std::vector<MeshFile> meshes{net(60, 0.25), net(60, 1.75)};
  const std::vector<std::string> contents{bytes_of(meshes[0], *find_format("obj")),
                                          bytes_of(meshes[1], *find_format("obj"))};
  ASSERT_NE(contents[0], contents[1]);
  ASSERT_TRUE(write_mesh_file(path, meshes[0]).ok());
  std::vector<Seconds> times;
  for (int i = 0; i < 15; ++i) {
    const SavingProcess saving(path, meshes[static_cast<std::size_t>(i % 2)]);
    const Clock::time_point start = Clock::now();
    ASSERT_EQ(saving.wait(), 0);
    times.push_back(Clock::now() - start);
  }
  std::sort(times.begin(), times.end());
  const Seconds typical = times[times.size() / 2];

  const unsigned seed = std::random_device()();
  std::mt19937 random(seed);
  const int kills = test::is_long_run() ? 200 : 70;
  int old_stayed = 0, new_came = 0, were_killed = 0, left_beside = 0;
  std::size_t now = 0;
  for (int i = 0; i < kills; ++i) {
    ASSERT_TRUE(write_mesh_file(path, meshes[now]).ok());
    const std::size_t next = 1 - now;
    // Spread evenly over the time that a save takes, and a little more.
    const double share = (i + std::uniform_real_distribution<>(0, 1)(random)) / kills;
    const SavingProcess saving(path, meshes[next]);
    wait_for(1.4 * share * typical);
    ::kill(saving.id, SIGKILL);
    were_killed += WIFSIGNALED(saving.wait());
    left_beside += folder.entry_count() > 1;
    const std::string found = io_test::whole_file(path);
    old_stayed += found == contents[now];
    new_came += found == contents[next];
    ASSERT_EQ(old_stayed + new_came, i + 1) << "neither the old nor the new file; seed " << seed << ", round " << i;
    now = next;
  }
  std::printf("%d kills (%d before the end, %d while writing) within %.2f ms, seed %u: %d times old, %d times new\n",
              kills, were_killed, left_beside, 1400 * typical.count(), seed, old_stayed, new_came);
  EXPECT_GT(were_killed, 0);
  ASSERT_TRUE(write_mesh_file(path, meshes[now]).ok());
  EXPECT_EQ(folder.entry_count(), 1u) << "the next save clears what the kills left";
}

}  // namespace
}  // namespace ryosen
