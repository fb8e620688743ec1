#include "app/editor/commands/path_completion.h"

#include <gtest/gtest.h>

#include "tests/support/app/program.h"

namespace ryosen {
namespace {

TEST(path_completion, goes_as_far_as_all_entries_agree) {
  test::TemporaryFolder folder;
  for (const char* name : {"cube.obj", "cup.obj", "torus.off", "deep/inner/one.off", ".hidden"})
    folder.write(name, "x");
  const auto completed = [&](const std::string& typed) { return completed_path(typed, folder.path()); };
  EXPECT_EQ(completed("c"), "cu");
  EXPECT_EQ(completed("cu"), "cu");
  EXPECT_EQ(completed("cub"), "cube.obj");
  EXPECT_EQ(completed("d"), "deep/") << "a folder goes on";
  EXPECT_EQ(completed("deep/"), "deep/inner/");
  EXPECT_EQ(completed("deep/inner/o"), "deep/inner/one.off");
  EXPECT_EQ(completed("nothing"), "nothing");
  EXPECT_EQ(completed(""), "") << "they have nothing in common";
  EXPECT_EQ(completed(folder.at("t")), folder.at("torus.off")) << "absolute";
  const auto is_off = [](const std::filesystem::path& file) { return file.extension() == ".off"; };
  EXPECT_EQ(completed_path("cu", folder.path(), is_off), "cu");
  EXPECT_EQ(completed_path("t", folder.path(), is_off), "torus.off");
}

TEST(path_completion, never_ends_within_a_letter) {
  test::TemporaryFolder folder;
  for (const char* name : {"稜.obj", "稟.obj"}) folder.write(name, "x");  // the first two bytes of three are equal
  EXPECT_EQ(completed_path("", folder.path()), "");
}

TEST(path_completion, lists_folders_first_and_no_hidden_names) {
  test::TemporaryFolder folder;
  for (const char* name : {"b.obj", "a.obj", "z/x", ".hidden"}) folder.write(name, "x");
  std::string listed;
  for (const FolderEntry& entry : entries_of_folder(folder.path())) listed += entry.name + " ";
  EXPECT_EQ(listed, "z a.obj b.obj ");
  EXPECT_TRUE(entries_of_folder(folder.at("missing")).empty());
}

}  // namespace
}  // namespace ryosen
