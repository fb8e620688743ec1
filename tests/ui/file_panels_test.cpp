// The panels that open and save files: what a failure says there, and clicks on folders.
#include <gtest/gtest.h>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;

// The buttons that accept, which Cancel follows: the words alone are drawn elsewhere too.
constexpr const char *open_button = "Open Cancel", *save_button = "Save Cancel";

class FilePanels : public testing::Test, protected test::Laid {
 protected:
  FilePanels() : Laid("torus.off") {
    file_ = folder_.copy(test::asset("cube.obj"), "cube.obj");
    EXPECT_TRUE(session.run("open " + file_argument(file_)).done());
  }

  void show(const std::string& panel) {
    ASSERT_TRUE(gui.run(session, "panel " + panel).done());
    frames(3);
  }
  // Once in the status line and once in the panel.
  void expect_reason_in_panel() {
    frames(3);
    ASSERT_NE(gui.said().en, "");
    EXPECT_EQ(DrawnText(gui).count(gui.said().en), 2u) << gui.said().en;
  }

  test::TemporaryFolder folder_;
  std::string file_;
};

TEST_F(FilePanels, a_file_that_cannot_be_read_is_said_why_where_it_was_chosen) {
  folder_.copy(file_, "other.obj");
  folder_.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n");
  show("open");
  click_on("bad.off");
  click_on(open_button);
  EXPECT_EQ(session.layout.open_panel, "open");
  EXPECT_TRUE(gui.said().en.starts_with(folder_.at("bad.off") + ":5:")) << gui.said().en;
  expect_reason_in_panel();
  click_on("other.obj");
  EXPECT_EQ(DrawnText(gui).count(gui.said().en), 1u) << "it is not about this file";
}

TEST_F(FilePanels, a_file_that_cannot_be_written_is_said_why_and_its_name_stays) {
  show("save");
  click_on("cube.obj");  // in the field, below the list
  for (const char c : std::string_view("x.yz")) gui.character(static_cast<unsigned>(c));
  frames(2);
  click_on(save_button);
  EXPECT_EQ(session.layout.open_panel, "save");
  expect_reason_in_panel();
  EXPECT_GE(DrawnText(gui).count("x.yz"), 1u);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"cube.obj"});
}

TEST_F(FilePanels, a_name_without_an_ending_is_that_of_a_file_as_the_open_one) {
  show("save");
  gui.text("xyz");  // in place of the name that is offered
  frames(2);
  click_on(save_button);
  EXPECT_EQ(session.layout.open_panel, "");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"cube.obj", "xyz.obj"}));
}

TEST_F(FilePanels, the_question_before_a_loss_says_why_saving_failed) {
  auto cube = read_mesh_file(file_);
  ASSERT_TRUE(cube);
  session.set_document(std::make_unique<Document>(std::move(cube).value(), folder_.at("missing/cube.obj")));
  ASSERT_TRUE(session.run("split 0-1").done());
  gui.leave(session, {true, {}});
  frames(3);
  click_on("Save Discard");
  EXPECT_FALSE(gui.wants_quit());
  EXPECT_EQ(session.layout.open_panel, "unsaved");
  expect_reason_in_panel();
}

// Behind the question before a loss an unnamed mesh gets its name, and what was asked for follows.
TEST_F(FilePanels, what_was_to_follow_a_save_follows_once_the_mesh_has_a_name) {
  const auto press = [&](int key) {
    gui.key(key, true);
    gui.key(key, false);
    frames(4);
  };
  const std::string other = folder_.copy(test::asset("ball.off"), "ball.off");
  for (const bool is_given_up : {true, false}) {
    ASSERT_TRUE(session.run("new").done());
    ASSERT_TRUE(session.run("cube").done());
    ASSERT_TRUE(session.document().path().empty());
    gui.leave(session, {false, other});
    frames(4);
    press(ImGuiKey_Enter);  // Save
    ASSERT_EQ(session.layout.open_panel, "save");
    gui.text((folder_.path() / "named.obj").string());
    frames(3);
    if (is_given_up)
      session.run("panel none");
    else
      press(ImGuiKey_Enter);
    frames(6);
    EXPECT_EQ(session.document().path() == other, !is_given_up);
    EXPECT_EQ(folder_.has("named.obj"), !is_given_up);
  }
}

TEST_F(FilePanels, the_second_press_of_a_double_click_on_a_folder_is_none_on_what_it_holds) {
  folder_.write("inner/torus.off", test::read_file(test::asset("torus.off")));
  show("open");
  const glm::dvec2 first_entry = DrawnText(gui).place("inner/");
  click(first_entry);
  click(first_entry);
  EXPECT_EQ(session.layout.open_panel, "open");
  EXPECT_EQ(session.document().path(), file_);
  ASSERT_NE(DrawnText(gui).place("torus.off").x, -1e9) << "the folder was entered";
  frames(30);
  click(first_entry);
  EXPECT_EQ(session.layout.open_panel, "open");
  click(first_entry);
  EXPECT_EQ(session.document().path(), folder_.at("inner/torus.off")) << "a double click on a file opens it";
}

TEST_F(FilePanels, a_name_is_none_of_the_next_folder_unless_it_is_written_there) {
  folder_.write("inner/torus.off", test::read_file(test::asset("torus.off")));
  const glm::dvec2 nowhere = DrawnText(gui).place("notdrawnanywhere");
  for (const std::string panel : {"open", "save"}) {
    show(panel);
    const std::size_t title = DrawnText(gui).count("cube.obj");
    click(DrawnText(gui).place("inner/"));
    frames(3);
    ASSERT_NE(DrawnText(gui).place("torus.off"), nowhere) << "the folder was entered";
    // Of the field and the row of the list, the field is left where it is for a file to be written.
    EXPECT_EQ(DrawnText(gui).count("cube.obj"), title - (panel == "open" ? 2 : 1)) << panel;
    ASSERT_TRUE(gui.run(session, "panel none").done());
    frames(3);
  }
}

TEST_F(FilePanels, above_a_folder_that_was_typed_with_its_slash_lies_what_it_is_in) {
  folder_.write("inner/torus.off", test::read_file(test::asset("torus.off")));
  show("open");
  gui.text("inner/");
  frames(2);
  gui.key(ImGuiKey_Enter, true);
  gui.key(ImGuiKey_Enter, false);
  frames(3);
  ASSERT_NE(DrawnText(gui).place("torus.off").x, -1e9) << "the folder was entered";
  click(DrawnText(gui).place("Folderabove"));
  frames(2);
  EXPECT_NE(DrawnText(gui).place("inner/").x, -1e9);
  EXPECT_TRUE(gui.owns_keys()) << "typing goes on";
}

}  // namespace
}  // namespace ryosen
