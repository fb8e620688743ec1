#include "ryosen/io/safe_write.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;
using io_test::TemporaryFolder;
using io_test::whole_file;

TEST(safe_write, writes_new_and_replaces_old) {
  const TemporaryFolder folder;
  ASSERT_TRUE(safe_write(folder / "a", "one").ok());
  EXPECT_EQ(whole_file(folder / "a"), "one");
  ASSERT_TRUE(safe_write(folder / "a", std::string(3000000, 'x')).ok());
  EXPECT_EQ(whole_file(folder / "a").size(), 3000000u);
  ASSERT_TRUE(safe_write(folder / "a", "").ok());
  EXPECT_EQ(whole_file(folder / "a"), "");
  EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(safe_write, new_files_honour_the_mask_and_old_ones_keep_their_permissions) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  ASSERT_TRUE(safe_write(folder / "new", "x").ok());
  ::umask(before);
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder / "new").permissions()), 0640u);
  fs::permissions(folder / "new", static_cast<fs::perms>(0604));
  ASSERT_TRUE(safe_write(folder / "new", "y").ok());
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder / "new").permissions()), 0604u);
}

TEST(safe_write, follows_links) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "sub");
  ASSERT_TRUE(safe_write(folder / "sub/real", "old").ok());
  fs::create_symlink("sub/real", folder / "link");
  fs::create_symlink("link", folder / "link2");
  ASSERT_TRUE(safe_write(folder / "link2", "new").ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_TRUE(fs::is_symlink(folder / "link2"));
  EXPECT_EQ(whole_file(folder / "sub/real"), "new");
  // A link to nothing makes its target.
  fs::create_symlink("sub/fresh", folder / "dangling");
  ASSERT_TRUE(safe_write(folder / "dangling", "made").ok());
  EXPECT_EQ(whole_file(folder / "sub/fresh"), "made");
  fs::create_symlink("loop", folder / "loop");
  EXPECT_FALSE(safe_write(folder / "loop", "x").ok());
}

TEST(safe_write, clears_what_killed_saves_of_this_file_left) {
  const TemporaryFolder folder;
  const auto make = [&](const char* name) { std::ofstream(folder / name) << "half"; };
  const std::vector<const char*> others{".a.ryosen-1.0.0", ".a.ryosen-1.", ".a.ryosen-.0",
                                        ".a.ryosen-x.0",   "a.ryosen-1.0", ".b.ryosen-1.0",
                                        ".a.b.ryosen-1.0", ".a.ryosen-1",  ".a.1.0"};
  for (const char* const name : others) make(name);
  for (const char* const name : {".a.ryosen-1.0", ".a.ryosen-4194304.17"}) make(name);
  fs::create_directory(folder / ".a.ryosen-2.0");
  ASSERT_TRUE(safe_write(folder / "a", "whole").ok());
  EXPECT_EQ(whole_file(folder / "a"), "whole");
  for (const char* const name : others) EXPECT_TRUE(fs::exists(folder / name)) << name << " is none of its files";
  EXPECT_FALSE(fs::exists(folder / ".a.ryosen-1.0"));
  EXPECT_FALSE(fs::exists(folder / ".a.ryosen-4194304.17"));
  EXPECT_TRUE(fs::exists(folder / ".a.ryosen-2.0")) << "a folder";
}

TEST(safe_write, leaves_what_a_living_process_is_writing) {
  const TemporaryFolder folder;
  const std::string path = folder / ".a.ryosen-1.0";
  const int living = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(::flock(living, LOCK_EX), 0);
  ASSERT_TRUE(safe_write(folder / "a", "whole").ok());
  EXPECT_TRUE(fs::exists(path));
  ::close(living);
  ASSERT_TRUE(safe_write(folder / "a", "whole").ok());
  EXPECT_FALSE(fs::exists(path)) << "its writer is dead by now";
}

// Writers of one file at the same time clear for each other and never what another is still writing.
TEST(safe_write, writers_of_one_file_do_not_disturb_each_other) {
  const TemporaryFolder folder;
  std::vector<std::thread> writers;
  std::atomic<int> failures = 0;
  for (char c = 'a'; c < 'e'; ++c)
    writers.emplace_back([&, c] {
      for (int i = 0; i < 100; ++i) failures += !safe_write(folder / "a", std::string(10000, c)).ok();
    });
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(whole_file(folder / "a").size(), 10000u);
  EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(safe_write, failures_say_why_and_leave_nothing) {
  const TemporaryFolder folder;
  const Status missing = safe_write(folder / "no/such/folder", "x");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.failure().exit_code, ExitCode::output_not_writable);
  EXPECT_NE(missing.failure().message.text.en.find("no/such/folder"), std::string::npos);
  EXPECT_FALSE(missing.failure().message.text.ja.empty());
  const Status onto_folder = safe_write(folder.path(), "x");
  ASSERT_FALSE(onto_folder.ok());
  EXPECT_EQ(onto_folder.failure().message.code, "output_is_folder");
  EXPECT_FALSE(safe_write("", "x").ok());
  EXPECT_FALSE(safe_write(folder.path() / "", "x").ok());
  EXPECT_EQ(folder.entry_count(), 0u);
}

// Permissions do not bind root: for a while it becomes a user whom they bind.
class AsOrdinaryUser {
 public:
  AsOrdinaryUser() {
    if (::geteuid() == 0) changed_ = ::seteuid(65534) == 0;
  }
  ~AsOrdinaryUser() {
    if (changed_) changed_ = ::seteuid(0) != 0;
  }
  AsOrdinaryUser(const AsOrdinaryUser&) = delete;
  AsOrdinaryUser& operator=(const AsOrdinaryUser&) = delete;

 private:
  bool changed_ = false;
};

TEST(safe_write, read_only_files_and_folders_are_refused) {
  const AsOrdinaryUser user;
  const TemporaryFolder folder;
  ASSERT_TRUE(safe_write(folder / "a", "old").ok());
  fs::permissions(folder / "a", static_cast<fs::perms>(0444));
  EXPECT_FALSE(safe_write(folder / "a", "new").ok());
  fs::permissions(folder.path(), static_cast<fs::perms>(0555));
  EXPECT_FALSE(safe_write(folder / "b", "new").ok());
  fs::permissions(folder.path(), static_cast<fs::perms>(0755));
  EXPECT_EQ(whole_file(folder / "a"), "old");
  EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(safe_write, a_folder_that_only_takes_files_gets_them) {
  const AsOrdinaryUser user;
  const TemporaryFolder folder;
  ASSERT_TRUE(safe_write(folder / "a", "old").ok());
  fs::permissions(folder.path(), static_cast<fs::perms>(0333));  // it cannot be opened, to be brought to the disk
  const Status status = safe_write(folder / "a", "new");
  fs::permissions(folder.path(), static_cast<fs::perms>(0755));
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(whole_file(folder / "a"), "new");
  EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(safe_write, devices_are_written_to_not_replaced) {
  ASSERT_TRUE(safe_write("/dev/null", "x").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  if (!fs::exists("/dev/full")) return;
  const Status full = safe_write("/dev/full", "x");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.failure().exit_code, ExitCode::output_not_writable);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(safe_write, a_pipe_that_nobody_reads_is_refused_at_once) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const Status alone = safe_write(folder / "pipe", "x");
  ASSERT_FALSE(alone.ok());
  EXPECT_EQ(alone.failure().exit_code, ExitCode::output_not_writable);
  EXPECT_NE(alone.failure().message.text.en.find("nobody reads this pipe"), std::string::npos);
  const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(safe_write(folder / "pipe", "hello").ok());
  char got[16] = {};
  EXPECT_EQ(::read(reader, got, sizeof got), 5);
  EXPECT_EQ(std::string(got), "hello");
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(safe_write, a_reader_who_goes_away_is_a_failure_and_not_the_end) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const Status status = safe_write("/dev/fd/" + std::to_string(ends[1]), "x");
  ::close(ends[1]);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.failure().message.text.en.find("has closed it"), std::string::npos)
      << status.failure().message.text.en;
}

TEST(safe_write, what_a_handed_descriptor_is_of_is_written_on_not_replaced) {
  const TemporaryFolder folder;
  const int file = ::open((folder / "log").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_GE(file, 0);
  ASSERT_EQ(::write(file, "before ", 7), 7);
  EXPECT_TRUE(safe_write("/proc/self/fd/" + std::to_string(file), "after").ok());
  ::close(file);
  EXPECT_EQ(whole_file(folder / "log"), "before after");
  EXPECT_EQ(folder.entry_count(), 1u);
}

}  // namespace
}  // namespace ryosen
