// A file that another program changes while it is open here: noticed, offered again, and not replaced unasked.
#include <gtest/gtest.h>
#include <imgui.h>

#include <fstream>

#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

using test::DrawnText;
using test::Laid;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

class ChangeOnDiskTest : public testing::Test {
 protected:
  ChangeOnDiskTest() : file_(folder_.write("shape.obj", triangle)) { run("open " + file_); }
  void run(const std::string& line) {
    const Outcome outcome = session().run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
  }
  void write(const char* text) { std::ofstream(file_) << text; }
  std::string on_disk() const {
    std::ifstream in(file_);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  Session& session() { return laid_.session; }
  bool is_told(const char* words) {
    laid_.frames(3);
    return DrawnText(laid_.gui).count(words) > 0;
  }

  test::TemporaryFolder folder_;
  std::string file_;
  Laid laid_{"cube.obj"};
};

TEST_F(ChangeOnDiskTest, is_told_over_the_view_in_both_languages) {
  EXPECT_FALSE(session().look_at_disk());
  EXPECT_FALSE(is_told("shape.objhaschangedondisk."));
  write(square);
  EXPECT_TRUE(session().look_at_disk());
  EXPECT_FALSE(session().look_at_disk()) << "no news any more";
  EXPECT_TRUE(is_told("shape.objhaschangedondisk."));
  run("language ja");
  EXPECT_TRUE(is_told("shape.obj?????????????"));
  std::filesystem::remove(file_);
  EXPECT_TRUE(session().look_at_disk());
  run("language en");
  EXPECT_TRUE(is_told("shape.objisgonefromthedisk."));
}

TEST_F(ChangeOnDiskTest, can_be_replaced_where_the_window_is_closed) {
  run("move_vertex v0 0,0,1");
  write(square);
  laid_.gui.leave(session(), {true, {}});
  EXPECT_TRUE(is_told("Anotherprogramhaschangedthefile"));
  laid_.click(DrawnText(laid_.gui).place("Replaceit"));
  EXPECT_TRUE(laid_.gui.wants_quit());
  EXPECT_NE(on_disk().find("v 0 0 1"), std::string::npos) << on_disk();
}

TEST_F(ChangeOnDiskTest, is_read_again_with_the_view_as_it_was) {
  run("view top");
  const Camera camera = session().view.camera;
  write(square);
  run("reload");
  EXPECT_EQ(session().mesh().live().vertices, 4u);
  EXPECT_EQ(session().view.camera, camera);
  EXPECT_EQ(session().change_on_disk(), FileState::Change::none);
  EXPECT_EQ(session().log(), std::vector<std::string>{"open " + file_});
}

TEST_F(ChangeOnDiskTest, is_read_again_by_a_button_after_a_question_where_edits_would_be_lost) {
  const auto press = [&](const char* words) {
    laid_.frames(3);
    laid_.click(DrawnText(laid_.gui).place(words));
    laid_.frames(4);
  };
  write(square);
  session().look_at_disk();
  press("Reload");
  EXPECT_EQ(session().mesh().live().vertices, 4u);
  run("move_vertex v0 0,0,1");
  write(triangle);
  session().look_at_disk();
  press("Reload");
  EXPECT_EQ(session().layout.open_panel, panel_opened_by(PanelOpener::loss).id);
  press("Reloadandlose1edit");
  EXPECT_EQ(session().mesh().live().vertices, 3u);
  write(square);
  session().look_at_disk();
  press("Keepmine");
  EXPECT_FALSE(is_told("Keepmine"));
  EXPECT_EQ(session().mesh().live().vertices, 3u);
  EXPECT_TRUE(session().document().is_modified()) << "no file holds it";
  laid_.gui.run(session(), "new");
  EXPECT_TRUE(is_told("Discard")) << "it asks before that is lost";
  EXPECT_EQ(session().mesh().live().vertices, 3u);
}

// Who reads it again wants what the other program has written.
TEST_F(ChangeOnDiskTest, is_never_replaced_by_enter_in_the_question_about_it) {
  const auto press = [&](int key) {
    laid_.gui.key(key, true);
    laid_.gui.key(key, false);
    laid_.frames(4);
  };
  run("move_vertex v0 0,0,1");
  run("move_vertex v0 0,0,2");
  write(square);
  session().look_at_disk();
  for (const bool quits : {false, true}) {
    if (quits)
      laid_.gui.leave(session(), {true, {}});
    else
      laid_.gui.run(session(), "reload");
    laid_.frames(4);
    EXPECT_EQ(is_told("Replaceit"), quits);
    press(ImGuiKey_Enter);
    EXPECT_EQ(session().layout.open_panel, "") << "Cancel has the keyboard";
    EXPECT_FALSE(laid_.gui.wants_quit());
    EXPECT_EQ(on_disk(), square);
    EXPECT_EQ(session().document().unsaved_edits(), 2u);
  }
  laid_.gui.run(session(), "reload");
  EXPECT_TRUE(is_told("Reloadandlose2edits"));
  laid_.click(DrawnText(laid_.gui).place("Saveminee"));
  EXPECT_EQ(session().layout.open_panel, panel_opened_by(PanelOpener::unnamed_save).id);
  EXPECT_EQ(on_disk(), square);
}

// It may change while the question is open.
TEST_F(ChangeOnDiskTest, takes_the_keyboard_from_the_button_that_would_replace_it) {
  run("move_vertex v0 0,0,1");
  laid_.gui.leave(session(), {true, {}});
  laid_.frames(4);
  write(square);
  session().look_at_disk();
  laid_.frames(4);
  laid_.gui.key(ImGuiKey_Enter, true);
  laid_.frames(3);
  EXPECT_EQ(on_disk(), square);
  EXPECT_EQ(session().layout.open_panel, "");
}

TEST_F(ChangeOnDiskTest, is_a_loss_where_the_file_is_gone) {
  std::filesystem::remove(file_);
  session().look_at_disk();
  EXPECT_TRUE(session().document().is_modified());
}

TEST_F(ChangeOnDiskTest, is_not_replaced_by_a_save_unless_that_is_wanted) {
  run("move_vertex v0 0,0,1");
  write(square);
  const Outcome refused = session().run("save");
  EXPECT_EQ(refused.exit_code, ExitCode::refused);
  EXPECT_NE(refused.sentence.en.find("reload"), std::string::npos) << refused.sentence.en;
  EXPECT_NE(refused.sentence.ja.find("keep_mine"), std::string::npos) << refused.sentence.ja;
  EXPECT_EQ(on_disk(), square);
  EXPECT_TRUE(is_told("shape.objhaschangedondisk."));
  run("save " + folder_.at("other.obj"));
  EXPECT_EQ(on_disk(), square);
  run("open " + file_);
  run("move_vertex v0 0,0,2");
  write(triangle);
  run("keep_mine");
  EXPECT_FALSE(is_told("shape.objhaschangedondisk."));
  run("save");
  EXPECT_NE(on_disk().find("0 0 2"), std::string::npos) << on_disk();
  run("move_vertex v0 0,0,3");
  run("save");
  EXPECT_FALSE(session().look_at_disk()) << "this program itself has written it";
}

TEST_F(ChangeOnDiskTest, is_written_anew_where_it_is_gone) {
  std::filesystem::remove(file_);
  EXPECT_TRUE(session().look_at_disk());
  EXPECT_FALSE(session().run("reload").done());
  EXPECT_EQ(session().mesh().live().vertices, 3u) << "what is open stays";
  run("save");
  EXPECT_EQ(session().change_on_disk(), FileState::Change::none);
  run("new");
  EXPECT_FALSE(session().run("reload").done()) << "there is no file";
}

}  // namespace
}  // namespace ryosen
