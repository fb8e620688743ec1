// A window that is killed, and what another program does to its file meanwhile: that survives, and the edits come back.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/app/real_window.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

class KilledWindow : public test::RealWindow {
 protected:
  // Opens a mesh, edits it and is killed.
  void edit_and_die(const std::string& mesh) {
    open(mesh);
    say("split 0-1");
    ASSERT_TRUE(shows([](const test::Frame& frame) { return frame.history == 1; })) << "nothing was split";
    vertices_ = last().vertices;
    editor_->end_by(SIGKILL);
    fs::remove(folder_.at("frames"));
  }
  // Starts again with another mesh, and leaves what is offered for later.
  void open_again() {
    open(test::asset("cube.obj"));
    EXPECT_EQ(last().panel, "recover");
    xdotool("mousemove 640 400 key Escape");
    ASSERT_TRUE(shows([](const test::Frame& frame) { return frame.panel == "-"; }));
  }
  bool says(const std::string& words) {
    return shows([&](const test::Frame& frame) { return frame.said.find(words) != std::string::npos; });
  }
  void quit() {
    xdotool("key ctrl+q");
    ASSERT_TRUE(test::wait_for([&] { return editor_->is_over(); }));
    EXPECT_EQ(editor_->exit_code(), 0);
    EXPECT_TRUE(state_.names().empty()) << "nothing is left to recover";
    fs::remove(folder_.at("frames"));
  }

  long vertices_ = 0;
};

TEST_F(KilledWindow, leaves_its_edits_and_no_save_replaces_what_another_program_wrote) {
  const std::string content = test::read_file(test::asset("torus.off")), theirs = "# theirs\n" + content;
  for (const bool by_rename : {false, true}) {
    if (!by_rename && !test::is_long_run()) continue;  // as the last test here writes
    SCOPED_TRACE(by_rename);
    const std::string mesh = folder_.write("torus.off", content);
    edit_and_die(mesh);
    if (by_rename)
      fs::rename(folder_.write("theirs.off", theirs), mesh);
    else
      folder_.write("torus.off", theirs);
    open_again();
    type("recover 1");
    ASSERT_TRUE(says("Another program has changed")) << last().said;
    EXPECT_EQ(last().vertices, 8) << "nothing was replayed";
    xdotool("key Escape");
    ASSERT_TRUE(shows([](const test::Frame& frame) { return frame.panel == "-"; }));
    say("recover 1 as_was");
    ASSERT_TRUE(shows([](const test::Frame& frame) { return frame.history == 1; })) << "nothing was recovered";
    EXPECT_EQ(last().vertices, vertices_);
    xdotool("mousemove 640 400 key ctrl+s");
    ASSERT_TRUE(says("Another program has changed torus.off")) << last().said;
    EXPECT_EQ(test::read_file(mesh), theirs);
    say("save " + folder_.at("mine.off"));
    ASSERT_TRUE(test::wait_for([&] { return folder_.has("mine.off"); }));
    EXPECT_EQ(test::read_file(mesh), theirs);
    quit();
    fs::remove(folder_.at("mine.off"));
  }
}

// A process that was killed holds its script for a moment; here the test does.
TEST_F(KilledWindow, is_offered_once_its_process_is_gone) {
  edit_and_die(folder_.write("torus.off", test::read_file(test::asset("torus.off"))));
  std::vector<int> held;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(state_.path())) {
    if (!entry.is_regular_file()) continue;
    held.push_back(::open(entry.path().c_str(), O_RDWR | O_CLOEXEC));
    ASSERT_EQ(::flock(held.back(), LOCK_EX | LOCK_NB), 0) << entry.path();
  }
  ASSERT_FALSE(held.empty());
  open(test::asset("cube.obj"));
  EXPECT_EQ(last().panel, "-");
  for (const int file : held) ::close(file);
  ASSERT_TRUE(shows([](const test::Frame& frame) { return frame.panel == "recover"; })) << "nothing was offered";
  xdotool("mousemove 640 400 key Escape");
  ASSERT_TRUE(shows([](const test::Frame& frame) { return frame.panel == "-"; }));
  say("recover 1");
  ASSERT_TRUE(shows([&](const test::Frame& frame) { return frame.vertices == vertices_; }));
  xdotool("mousemove 640 400 key ctrl+s");
  ASSERT_TRUE(says("save"));
  quit();
}

TEST_F(KilledWindow, watches_its_file_from_the_recovery_on) {
  const std::string content = test::read_file(test::asset("torus.off")), theirs = "# theirs\n" + content;
  const std::string mesh = folder_.write("torus.off", content);
  edit_and_die(mesh);
  open_again();
  say("recover 1");
  ASSERT_TRUE(shows([](const test::Frame& frame) { return frame.history == 1; })) << "nothing was recovered";
  folder_.write("torus.off", theirs);
  xdotool("mousemove 640 400 key ctrl+s");
  ASSERT_TRUE(says("Another program has changed torus.off")) << last().said;
  EXPECT_EQ(test::read_file(mesh), theirs);
  say("keep_mine");
  xdotool("mousemove 640 400 key ctrl+s");
  ASSERT_TRUE(test::wait_for([&] { return test::read_file(mesh) != theirs; }));
  quit();
}

}  // namespace
}  // namespace ryosen
