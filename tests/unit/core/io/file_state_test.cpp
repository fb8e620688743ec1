#include "ryosen/io/file_state.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace ryosen {
namespace {

TEST(file_state, tells_what_has_become_of_a_file) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("ryosen_file_state_" + std::to_string(::getpid()));
  std::ofstream(path) << "one";
  const FileState before = FileState::of(path);
  EXPECT_EQ(before.since(path), FileState::Change::none);
  std::ofstream(path) << "two and more";
  EXPECT_EQ(before.since(path), FileState::Change::changed);
  EXPECT_EQ(FileState::of(path).since(path), FileState::Change::none);
  std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::hours(1));
  EXPECT_EQ(FileState::of(path).since(path), FileState::Change::none);
  std::filesystem::remove(path);
  EXPECT_EQ(before.since(path), FileState::Change::gone);
  EXPECT_EQ(FileState().since(path), FileState::Change::none) << "of no file";
  EXPECT_EQ(FileState::of("/dev/null").since("/dev/null"), FileState::Change::none);
}

TEST(file_state, comes_back_from_its_text) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("ryosen_file_text_" + std::to_string(::getpid()));
  std::ofstream(path) << "one";
  const FileState state = FileState::of(path);
  EXPECT_TRUE(state.is_known());
  EXPECT_EQ(FileState::from_text(state.text()), state);
  EXPECT_EQ(FileState::from_text(state.text()).since(path), FileState::Change::none);
  EXPECT_EQ(FileState().text(), "");
  EXPECT_EQ(FileState::of_none_that_is().since(path), FileState::Change::changed);
  EXPECT_EQ(FileState::of_none_that_is().since(path / "below"), FileState::Change::gone);
  for (const char* wrong : {"", " ", "1", "1 2", "1 2 x", "1 2 3 4", "x", "1 2 99999999999999999999", "1 2 3 "})
    EXPECT_FALSE(FileState::from_text(wrong).is_known()) << wrong;
  std::filesystem::remove(path);
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
