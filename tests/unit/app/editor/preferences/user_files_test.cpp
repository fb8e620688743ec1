#include "app/editor/preferences/user_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/editor/preferences/user_folders.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class KeptByUser : public testing::Test {
 protected:
  std::filesystem::path folder() const { return folder_.path() / "ryosen"; }
  std::string content(const std::string& name) const { return test::read_file((folder() / name).string()); }
  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories(folder());
    std::ofstream(folder() / name) << text;
  }
  // What a window does that is opened, does these lines, and is closed.
  Text open(std::initializer_list<std::string> lines, const std::string& file = "") {
    session_ = std::make_unique<Session>(std::make_unique<Document>());
    UserFiles files(folder());
    const Text said = files.begin(*session_);
    if (!file.empty()) {
      EXPECT_TRUE(session_->run("open " + file).done());
    }
    for (const std::string& line : lines) EXPECT_TRUE(session_->run(line).done()) << line;
    EXPECT_FALSE(files.keep(*session_));
    return said;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<Session> session_;
};

TEST_F(KeptByUser, is_as_it_was_left_the_next_time) {
  open({"theme light", "prefer scale 1.5", "language ja", "bind Ctrl+K shot", "bind G none", "panel history off",
        "panel growth on", "panel totals right", "columns left 300"});
  EXPECT_EQ(open({}).en, "");
  EXPECT_EQ(session_->view.settings.theme, Theme::light);
  EXPECT_EQ(session_->preferences.ui_scale, 1.5);
  EXPECT_EQ(session_->preferences.language, Language::japanese);
  const std::vector<KeyBinding> own{{"Ctrl+K", "shot"}, {"G", ""}};
  EXPECT_EQ(session_->preferences.bindings, own);
  const std::vector<std::string> layout{"panel totals right", "panel history off", "panel growth on",
                                        "columns left 300"};
  EXPECT_EQ(session_->layout.commands(), layout);
  EXPECT_EQ(session_->layout.wanted, "") << "they are shown as they were, none is opened";
  EXPECT_NE(content("preferences").find("\ntheme light\n"), std::string::npos) << content("preferences");
}

TEST_F(KeptByUser, is_not_written_before_something_changes) {
  open({});
  EXPECT_FALSE(std::filesystem::exists(folder()));
}

TEST_F(KeptByUser, is_not_what_a_flag_said) {
  open({"theme light"});
  Session session(std::make_unique<Document>());
  UserFiles files(folder());
  files.begin(session);
  session.preferences.language = Language::japanese;  // --lang ja
  files.take_as_given(session);
  ASSERT_TRUE(session.run("prefer samples 2").done());
  EXPECT_FALSE(files.keep(session));
  EXPECT_EQ(content("preferences").find("language"), std::string::npos);
  EXPECT_NE(content("preferences").find("samples 2\n"), std::string::npos);
  EXPECT_NE(content("preferences").find("theme light\n"), std::string::npos);
}

TEST_F(KeptByUser, broken_preferences_are_a_sentence_and_the_defaults_and_are_put_aside) {
  const std::string broken = "theme light\n\nscale huge\n";
  write("preferences", broken);
  const Text said = open({});
  EXPECT_NE(said.en.find((folder() / "preferences").string() + ":3: scale is"), std::string::npos) << said.en;
  EXPECT_EQ(session_->view.settings.theme, Theme::dark) << "all or nothing";
  EXPECT_EQ(content("preferences"), broken) << "as long as nothing is changed";
  open({"prefer samples 3"});
  EXPECT_EQ(content("preferences.broken"), broken);
  EXPECT_EQ(open({}).en, "");
  EXPECT_EQ(session_->preferences.samples, 3);
}

TEST_F(KeptByUser, broken_lines_of_every_kind_are_told_with_their_place) {
  for (const char* line :
       {"theme", "theme dark light", "theme purple", "bind", "bind Q", "bind Q nonsense", "scale 0"}) {
    write("preferences", std::string("# remark\n") + line + "\n");
    EXPECT_NE(open({}).en.find("preferences:2: "), std::string::npos) << line;
  }
  std::string nested;
  for (int i = 0; i < 7000; ++i) nested += "bind Ctrl+K ";
  write("preferences", nested + "undo\n");
  EXPECT_NE(open({}).en.find("preferences:1: bind: a key cannot bind another key"), std::string::npos);
  write("preferences", "");
  for (const char* line : {"split 0-1", "panel nonsense on", "columns left 9999", "columns"}) {
    write("layout", std::string("panel tools fold\n") + line + "\n");
    EXPECT_NE(open({}).en.find("layout:2: "), std::string::npos) << line;
    EXPECT_TRUE(session_->layout.commands().empty()) << line;
  }
}

TEST_F(KeptByUser, lines_of_another_version_stay_and_are_told_of) {
  write("preferences", "theme light\nhologram on\n");
  const Text said = open({"prefer samples 2"});
  EXPECT_NE(said.en.find("hologram"), std::string::npos) << said.en;
  EXPECT_EQ(session_->view.settings.theme, Theme::light);
  EXPECT_NE(content("preferences").find("hologram on\n"), std::string::npos);
}

TEST_F(KeptByUser, a_folder_that_cannot_be_written_is_said_once) {
  std::ofstream(folder()) << "a file in its place";
  Session session(std::make_unique<Document>());
  UserFiles files(folder());
  files.begin(session);
  ASSERT_TRUE(session.run("theme light").done());
  const auto fault = files.keep(session);
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->en.find("cannot be kept"), std::string::npos);
  ASSERT_TRUE(session.run("theme dark").done());
  EXPECT_FALSE(files.keep(session));
}

TEST_F(KeptByUser, the_last_ten_files_the_latest_first) {
  for (int i = 0; i < 12; ++i) open({}, folder_.copy(test::asset("torus.off"), "torus " + std::to_string(i) + ".off"));
  open({}, folder_.at("torus 5.off"));
  ASSERT_EQ(session_->preferences.recent.size(), UserFiles::most_recent);
  EXPECT_EQ(session_->preferences.recent[0], folder_.at("torus 5.off"));
  EXPECT_EQ(session_->preferences.recent[1], folder_.at("torus 11.off"));
  open({});
  EXPECT_EQ(session_->preferences.recent[9], folder_.at("torus 2.off"));
}

TEST(user_folder, is_named_by_the_variables_of_the_desktop) {
  const char* const before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before ? before : "";
  setenv("XDG_CONFIG_HOME", "/somewhere", 1);
  EXPECT_EQ(user_folder(UserFolder::config), "/somewhere/ryosen");
  setenv("XDG_CONFIG_HOME", "not/whole", 1);
  EXPECT_TRUE(user_folder(UserFolder::config).string().ends_with(".config/ryosen"));
  before ? setenv("XDG_CONFIG_HOME", kept.c_str(), 1) : unsetenv("XDG_CONFIG_HOME");
}

TEST(preferences_of_a_picture, are_those_of_the_file_that_is_named) {
  test::TemporaryFolder folder;
  const std::filesystem::path users = folder.path() / "ryosen";
  std::filesystem::create_directories(users);
  std::ofstream(users / "preferences") << "theme light\n";
  const std::vector<std::string> config{"XDG_CONFIG_HOME=" + folder.path().string()};
  const auto shot = [&](std::vector<std::string> more, const std::string& name) {
    more.insert(more.begin(), {"shot", test::asset("torus.off"), "--size", "64x48", "-o", folder.at(name)});
    const auto run = test::run_program(more, {}, config);
    return run.exit_code == 0 ? test::read_file(folder.at(name)) : run.err;
  };
  const std::string dark = shot({"--theme", "dark"}, "dark.png"), light = shot({"--theme", "light"}, "light.png");
  ASSERT_NE(dark, light);
  EXPECT_EQ(shot({}, "a.png"), dark) << "the user's own are not read";
  EXPECT_EQ(shot({"--preferences", (users / "preferences").string()}, "b.png"), light);
  const std::string broken = folder.write("broken", "theme purple\n");
  EXPECT_NE(shot({"--preferences", broken}, "c.png").find("broken:1"), std::string::npos);
  EXPECT_NE(shot({"--preferences", folder.at("nowhere")}, "d.png").find("nowhere"), std::string::npos);
}

}  // namespace
}  // namespace ryosen
