#include "core/io/safe_write.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

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

}  // namespace
}  // namespace ryosen
