// A command that is new in the table is suggested, and one that takes long waits until the frame is laid out.
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/editor/session/session.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/probe_command.h"

namespace ryosen {
namespace {

class ScopedCommandTest : public testing::Test, protected test::Laid {
 protected:
  ScopedCommandTest() : Laid("cube.obj") {
    session.frontend.on_progress = [this](double) {
      was_laying_out_.push_back(gui.is_laying_out());
      return true;
    };
    session.run("panel command");
    frames(3);
  }

  void type(std::string_view text) {
    for (const char c : text) gui.character(static_cast<unsigned>(c));
    frames(2);
  }
  void enter() {
    gui.key(ImGuiKey_Enter, true);
    gui.key(ImGuiKey_Enter, false);
    frames(3);
  }

  std::vector<bool> was_laying_out_;
};

TEST_F(ScopedCommandTest, that_takes_long_waits_for_the_end_of_the_frame) {
  const ScopedCommand probe(test::probe_row());
  type("probe 3");
  enter();
  EXPECT_EQ(was_laying_out_, std::vector<bool>{false});
  EXPECT_EQ(session.mesh().live().vertices, 9u);
  EXPECT_EQ(gui.said().en, "probe 3: done");
}

TEST_F(ScopedCommandTest, that_is_quick_is_done_at_once) {
  CommandRow row = test::probe_row();
  row.is_long = false;
  const ScopedCommand probe(row);
  type("probe 3");
  enter();
  EXPECT_EQ(was_laying_out_, std::vector<bool>{true});
}

TEST_F(ScopedCommandTest, that_is_long_and_wrong_fails_where_it_was_typed) {
  const ScopedCommand probe(test::probe_row());
  type("probe x");
  enter();
  EXPECT_TRUE(was_laying_out_.empty());
  EXPECT_EQ(session.layout.open_panel, "command");
  EXPECT_EQ(gui.said().en, "probe needs a number");
}

TEST_F(ScopedCommandTest, is_suggested) {
  const ScopedCommand probe(test::probe_row());
  type("prob");
  click_on("utsavertexonthefirst");
  click(test::DrawnText(gui).place("probe"));  // the field, which is drawn before its suggestions
  gui.key(ImGuiKey_End, true);
  frames(1);
  gui.key(ImGuiKey_End, false);
  type("4");
  enter();
  EXPECT_EQ(gui.said().en, "probe 4: done");
}

}  // namespace
}  // namespace ryosen
