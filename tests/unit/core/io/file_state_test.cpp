#include "ryosen/io/file_state.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace ryosen {
namespace {

using Change = FileState::Change;
namespace fs = std::filesystem;

// A file with the content "one", and its state.
class FileStateTest : public testing::Test {
 protected:
  FileStateTest() {
    write("one");
    state_ = FileState::of(path_);
    state_.learn_content(path_);
  }
  ~FileStateTest() override { fs::remove(path_); }
  void write(const std::string& content) const { std::ofstream(path_) << content; }

  const fs::path path_ = fs::temp_directory_path() / ("ryosen_file_state_" + std::to_string(::getpid()));
  FileState state_;
};

TEST_F(FileStateTest, tells_a_change_and_that_the_file_is_gone) {
  EXPECT_EQ(state_.since(path_), Change::none);
  write("two and more");
  EXPECT_EQ(state_.since(path_), Change::changed);
  EXPECT_EQ(FileState::of(path_).since(path_), Change::none);
  fs::remove(path_);
  EXPECT_EQ(state_.since(path_), Change::gone);
  EXPECT_EQ(FileState().since(path_), Change::none) << "of no file";
  EXPECT_EQ(FileState::of("/dev/null").since("/dev/null"), Change::none);
}

// Length and time may stay: an archive, `touch -r` and a clock in large steps do that.
TEST_F(FileStateTest, tells_a_change_that_keeps_length_and_time) {
  const auto time = fs::last_write_time(path_);
  for (const bool is_other_file : {false, true}) {
    if (is_other_file) fs::remove(path_);
    write("two");
    fs::last_write_time(path_, time);
    EXPECT_EQ(state_.since(path_), Change::changed) << is_other_file;
    EXPECT_EQ(FileState::from_text(state_.text()).since(path_), Change::changed) << is_other_file;
  }
}

TEST_F(FileStateTest, takes_the_same_content_for_no_change) {
  fs::last_write_time(path_, fs::last_write_time(path_) + std::chrono::hours(1));
  EXPECT_EQ(state_.since(path_), Change::none) << "touched";
  ASSERT_EQ(::chmod(path_.c_str(), 0600), 0);
  EXPECT_EQ(state_.since(path_), Change::none) << "made private";
  fs::remove(path_);
  write("one");
  EXPECT_EQ(state_.since(path_), Change::none) << "written again";
}

TEST_F(FileStateTest, learns_no_content_of_a_later_state) {
  FileState early = FileState::of(path_);
  write("another");
  early.learn_content(path_);
  EXPECT_EQ(early.since(path_), Change::changed);
  EXPECT_EQ(std::ranges::count(early.text(), ' '), 2) << early.text();
}

TEST_F(FileStateTest, of_an_unknown_content_is_none_other_for_its_status) {
  FileState state = FileState::of(path_);
  ASSERT_EQ(::chmod(path_.c_str(), 0600), 0);
  EXPECT_EQ(state.since(path_), Change::none);
  EXPECT_EQ(state.follow(path_), Change::none);
  state.learn_content(path_);
  ASSERT_EQ(::chmod(path_.c_str(), 0640), 0);
  EXPECT_EQ(state.since(path_), Change::none);
  const auto time = fs::last_write_time(path_);
  write("two");
  fs::last_write_time(path_, time);
  EXPECT_EQ(state.since(path_), Change::changed);
}

TEST_F(FileStateTest, is_followed_through_every_change) {
  EXPECT_EQ(state_.follow(path_), Change::none);
  for (int round = 0; round < 2; ++round) {
    write("two");
    EXPECT_EQ(state_.follow(path_), Change::changed) << round;
    EXPECT_EQ(state_.follow(path_), Change::changed) << "again, " << round;
    fs::remove(path_);
    EXPECT_EQ(state_.follow(path_), Change::gone) << round;
    write("one");
    EXPECT_EQ(state_.follow(path_), Change::none) << "back, " << round;
  }
  FileState none;
  EXPECT_EQ(none.follow(path_), Change::none);
  EXPECT_FALSE(none.is_known());
}

TEST_F(FileStateTest, comes_back_from_its_text) {
  EXPECT_TRUE(state_.is_known());
  const FileState again = FileState::from_text(state_.text());
  EXPECT_EQ(again.text(), state_.text());
  EXPECT_EQ(again.since(path_), Change::none);
  const std::string times = state_.text().substr(0, state_.text().rfind(' '));
  EXPECT_EQ(FileState::from_text(times).since(path_), Change::none) << "without its content";
  EXPECT_EQ(FileState::from_text(times + " x").text(), times);
  EXPECT_EQ(FileState().text(), "");
  EXPECT_EQ(FileState::of_none_that_is().since(path_), Change::changed);
  EXPECT_EQ(FileState::of_none_that_is().since(path_ / "below"), Change::gone);
  for (const char* wrong : {"", " ", "1", "1 2", "1 2 x", "x", "1 2 99999999999999999999"})
    EXPECT_FALSE(FileState::from_text(wrong).is_known()) << wrong;
}

TEST(content_hash, is_equal_for_equal_bytes_alone) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("ryosen_content_" + std::to_string(::getpid()));
  std::set<std::uint64_t> hashes;
  const std::size_t piece = std::size_t{1} << 18;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{7}, std::size_t{8}, std::size_t{9},
                                 piece - 1, piece, piece + 1, 2 * piece, 2 * piece + 3}) {
    for (const char fill : {'\0', 'a'}) {
      if (size == 0 && fill == 'a') continue;
      std::ofstream(path) << std::string(size, fill);
      const auto hash = content_hash(path);
      ASSERT_TRUE(hash) << size;
      EXPECT_EQ(content_hash(path), hash) << size;
      EXPECT_TRUE(hashes.insert(*hash).second) << size << " of " << int(fill);
    }
  }
  std::string bytes(piece + 9, 'a');
  for (const std::size_t at : {std::size_t{0}, std::size_t{8}, piece - 1, piece, piece + 8}) {
    bytes[at] = 'b';
    std::ofstream(path) << bytes;
    EXPECT_TRUE(hashes.insert(content_hash(path).value()).second) << at;
  }
  std::filesystem::remove(path);
  EXPECT_FALSE(content_hash(path)) << "there is none";
  EXPECT_FALSE(content_hash("/dev/null"));
  EXPECT_FALSE(content_hash(std::filesystem::temp_directory_path()));
}

}  // namespace
}  // namespace ryosen
