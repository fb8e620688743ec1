#include "app/editor/document/run_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fcntl.h>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

using Policy = RunFiles::Policy;

std::string code(const Status& status) { return status ? std::string() : std::string(status.failure().message.code); }

TEST(run_files, what_is_read_is_not_written_under_any_name) {
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", "x");
  std::filesystem::create_symlink("in.off", folder.at("soft.png"));
  std::filesystem::create_hard_link(in, folder.at("hard.png"));
  std::filesystem::create_directory_symlink(".", folder.at("here"));
  RunFiles files(Policy::keep);
  files.reads(in, FileRole::mesh);
  files.reads(folder.at("later.png"), FileRole::reference);
  std::filesystem::create_symlink("later.png", folder.at("to_later.png"));
  const int descriptor = ::open(in.c_str(), O_RDONLY);
  ASSERT_GE(descriptor, 0);
  const std::string handed = "/proc/self/fd/" + std::to_string(descriptor);
  for (const std::string& name : {in, folder.at("./in.off"), folder.at("soft.png"), folder.at("hard.png"),
                                  folder.at("here/in.off"), folder.at("to_later.png"), handed}) {
    const Status status = files.may_write(name, FileRole::picture);
    EXPECT_EQ(code(status), "input_would_be_replaced") << name;
    if (status) continue;
    EXPECT_EQ(status.failure().exit_code, ExitCode::output_not_writable);
  }
  ::close(descriptor);
  EXPECT_EQ(code(files.may_write(folder.at("other.off"), FileRole::saved)), "");
  EXPECT_EQ(code(files.may_write("/dev/null", FileRole::saved)), "");
  RunFiles may(Policy::overwrite);
  may.reads(in, FileRole::mesh);
  EXPECT_EQ(code(may.may_write(in, FileRole::saved)), "");
  EXPECT_EQ(code(may.may_write(folder.at("hard.png"), FileRole::picture)), "");
}

// A picture is a PNG file: under the name of another format every viewer would take it for that.
TEST(run_files, no_picture_takes_the_name_of_another_format) {
  const TemporaryFolder folder;
  for (const Policy policy : {Policy::keep, Policy::by_kind, Policy::overwrite}) {
    const RunFiles files(policy);
    for (const FileRole role : {FileRole::picture, FileRole::difference}) {
      for (const char* const name :
           {"x.jpg", "x.JPEG", "x.svg", "x.webp", "x.gif", "x.bmp", "x.pdf", "x.obj", "a.png.jpg", "x.jp2", "x.png2"}) {
        const Status status = files.may_write(folder.at(name), role);
        ASSERT_EQ(code(status), "unknown_format") << name;
        EXPECT_EQ(status.failure().exit_code, ExitCode::usage);
        EXPECT_NE(status.failure().message.text.en.find(".png"), std::string::npos);
      }
      for (const char* const name : {"x.png", "x.PNG", "x.jpg.png", "x", ".png", "shot.001", "v1.2", "two words.a b"})
        EXPECT_EQ(code(files.may_write(folder.at(name), role)), "") << name;
    }
    EXPECT_EQ(code(files.may_write(folder.at("x.obj"), FileRole::result)), "");
  }
  EXPECT_EQ(code(RunFiles(Policy::keep).may_write("/dev/null", FileRole::picture)), "");
}

TEST(run_files, both_roles_are_named_in_both_languages) {
  const TemporaryFolder folder;
  RunFiles files(Policy::keep);
  files.reads(folder.at("ref.png"), FileRole::reference);
  const Text text = files.may_write(folder.at("ref.png"), FileRole::picture).failure().message.text;
  EXPECT_NE(text.en.find("ref.png is the reference of --compare; a picture would replace it."), text.en.npos)
      << text.en;
  EXPECT_NE(text.ja.find("ref.png は比較の基準画像（--compare）です。画像で置き換える"), text.ja.npos) << text.ja;
}

TEST(run_files, only_the_same_document_is_saved_to_its_file_again) {
  const TemporaryFolder folder;
  RunFiles files(Policy::keep);
  files.writes(folder.at("a.obj"), FileRole::saved);
  EXPECT_EQ(code(files.may_write(folder.at("a.obj"), FileRole::saved)), "");
  EXPECT_EQ(code(files.may_write(folder.at("a.obj"), FileRole::picture)), "output_would_be_replaced");
  EXPECT_EQ(code(files.may_write(folder.at("a.obj"), FileRole::result)), "output_would_be_replaced");
  files.begin_document();
  EXPECT_EQ(code(files.may_write(folder.at("a.obj"), FileRole::saved)), "output_would_be_replaced");
  files.writes(folder.at("p.png"), FileRole::picture);
  EXPECT_EQ(code(files.may_write(folder.at("p.png"), FileRole::picture)), "output_would_be_replaced");
  EXPECT_EQ(code(files.may_write(folder.at("p.png"), FileRole::difference)), "output_would_be_replaced");
}

TEST(run_files, a_descriptor_that_was_handed_takes_one_output) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string handed = "/dev/fd/" + std::to_string(ends[1]);
  RunFiles files(Policy::keep);
  EXPECT_EQ(code(files.may_write(handed, FileRole::picture)), "");
  files.writes(handed, FileRole::picture);
  EXPECT_EQ(code(files.may_write(handed, FileRole::difference)), "output_would_be_replaced");
  files.writes("/dev/null", FileRole::picture);
  EXPECT_EQ(code(files.may_write("/dev/null", FileRole::difference)), "") << "a device takes any number";
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(run_files, a_file_that_was_saved_anew_is_another_one) {
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", "x");
  std::filesystem::create_hard_link(in, folder.at("old.png"));
  RunFiles files(Policy::by_kind);
  files.reads(in, FileRole::mesh);
  EXPECT_EQ(code(files.may_write(folder.at("old.png"), FileRole::picture)), "input_would_be_replaced");
  std::filesystem::rename(folder.write("beside", "y"), in);
  files.writes(in, FileRole::saved);
  EXPECT_EQ(code(files.may_write(folder.at("old.png"), FileRole::picture)), "") << "no longer the mesh";
  EXPECT_EQ(code(files.may_write(in, FileRole::picture)), "input_would_be_replaced");
}

TEST(run_files, a_name_that_the_run_will_write_is_not_free) {
  const TemporaryFolder folder;
  folder.write("there.png", "x");
  std::filesystem::create_symlink("nowhere.png", folder.at("link.png"));
  RunFiles files(Policy::overwrite), plan = files;
  plan.writes(folder.at("./planned.png"), FileRole::picture);
  EXPECT_TRUE(files.is_free(folder.at("planned.png")));
  files.plans(plan);
  for (const char* name : {"planned.png", "there.png", "link.png"})
    EXPECT_FALSE(files.is_free(folder.at(name))) << name;
  EXPECT_TRUE(files.is_free(folder.at("other.png")));
  EXPECT_EQ(code(files.may_write(folder.at("planned.png"), FileRole::picture)), "") << "for whoever planned it";
}

TEST(run_files, a_user_at_the_window_may_replace_like_by_like) {
  const TemporaryFolder folder;
  RunFiles files(Policy::by_kind);
  files.reads(folder.at("a.obj"), FileRole::mesh);
  EXPECT_EQ(code(files.may_write(folder.at("a.obj"), FileRole::saved)), "");
  EXPECT_EQ(code(files.may_write(folder.at("a.obj"), FileRole::picture)), "input_would_be_replaced");
  files.writes(folder.at("p.png"), FileRole::picture);
  EXPECT_EQ(code(files.may_write(folder.at("p.png"), FileRole::picture)), "");
}

}  // namespace
}  // namespace ryosen::test
