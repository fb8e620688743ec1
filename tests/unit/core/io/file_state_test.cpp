#include "core/io/file_state.h"

#include <gtest/gtest.h>

#include <fstream>

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

}  // namespace
}  // namespace ryosen
