// What a crash left of a file that another program has changed since: the panel says so and has a button for each
// choice.
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class RecoverPanelTest : public testing::Test {
 protected:
  RecoverPanelTest() {
    if (const char* const before = std::getenv("XDG_STATE_HOME")) before_ = before;
    setenv("XDG_STATE_HOME", state_.path().c_str(), 1);
    file_ = files_.copy(test::asset("torus.off"), "a.off");
    Session crashed(Document::open(file_).value());
    Autosave autosave(recovery_folder());
    crashed.frontend.autosave = &autosave;
    autosave.begin(crashed.document());
    EXPECT_TRUE(crashed.run("split 0-1").done());
    hash_ = crashed.mesh().hash();
  }
  ~RecoverPanelTest() override { before_ ? setenv("XDG_STATE_HOME", before_->c_str(), 1) : unsetenv("XDG_STATE_HOME"); }

  void change() const { files_.write("a.off", "# theirs\n" + test::read_file(test::asset("torus.off"))); }
  void open_panel() {
    ASSERT_TRUE(laid_.gui.run(laid_.session, "panel recover").done());
    laid_.frames(3);
  }
  std::size_t count(std::string_view text) const { return test::DrawnText(laid_.gui).count(text); }
  void press(std::string_view text) {
    ASSERT_GT(count(text), 0u) << text;
    laid_.click(test::DrawnText(laid_.gui).last_place(text));
    laid_.frames(4);
  }

  test::TemporaryFolder state_, files_;
  std::optional<std::string> before_;
  std::string file_;
  std::uint64_t hash_ = 0;
  test::Laid laid_{"cube.obj"};
};

constexpr std::string_view changed = "Anotherprogramhaschanged", as_was = "Recoverasitwas",
                           as_is = "Redoonthefileasitis";

TEST_F(RecoverPanelTest, says_what_was_changed_and_recovers_the_mesh_as_it_was) {
  change();
  open_panel();
  EXPECT_GT(count(changed), 0u);
  EXPECT_GT(count(as_is), 0u);
  press(as_was);
  EXPECT_EQ(laid_.session.mesh().hash(), hash_);
  EXPECT_EQ(laid_.session.layout.open_panel, "");
  EXPECT_GT(count("a.offhaschangedondisk."), 0u) << "over the view, with Reload and Keep mine";
  EXPECT_EQ(laid_.gui.run(laid_.session, "save").exit_code, ExitCode::refused);
}

TEST_F(RecoverPanelTest, does_the_edits_again_on_the_file_as_it_is) {
  change();
  open_panel();
  press(as_is);
  EXPECT_EQ(laid_.session.mesh().hash(), hash_) << "only a remark was added";
  EXPECT_EQ(count("a.offhaschangedondisk."), 0u);
  EXPECT_TRUE(laid_.gui.run(laid_.session, "save").done());
  EXPECT_TRUE(test::read_file(file_).find("# theirs") != std::string::npos);
}

// It changes while the panel is open: the panel comes back with both choices.
TEST_F(RecoverPanelTest, comes_back_with_the_choices_where_the_file_changes_meanwhile) {
  open_panel();
  EXPECT_EQ(count(changed), 0u);
  EXPECT_EQ(count(as_was), 0u);
  change();
  press("Recover");
  EXPECT_EQ(laid_.session.mesh().live().vertices, 8u) << "nothing was replayed";
  EXPECT_EQ(laid_.session.layout.open_panel, "recover");
  press(as_was);
  EXPECT_EQ(laid_.session.mesh().hash(), hash_);
}

// The other program's mesh lacks what the edit is about: the whole reason stands in the panel.
TEST_F(RecoverPanelTest, says_why_an_edit_cannot_be_done_again) {
  files_.write("a.off", "OFF 4 1 0 0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 3\n");
  open_panel();
  EXPECT_EQ(count("cannotbedoneagain"), 0u);
  press(as_is);
  EXPECT_EQ(laid_.session.layout.open_panel, "recover");
  EXPECT_GT(count("cannotbedoneagain"), 0u);
  EXPECT_GT(count(as_was), 0u);
}

TEST_F(RecoverPanelTest, has_one_choice_where_the_file_is_gone) {
  std::filesystem::remove(file_);
  open_panel();
  EXPECT_GT(count("hasgonefromthedisk"), 0u);
  EXPECT_EQ(count(as_is), 0u);
  press(as_was);
  EXPECT_EQ(laid_.session.mesh().hash(), hash_);
  EXPECT_TRUE(laid_.gui.run(laid_.session, "save").done());
  EXPECT_TRUE(std::filesystem::exists(file_));
}

TEST_F(RecoverPanelTest, says_it_in_japanese_and_discards) {
  change();
  laid_.session.preferences.language = Language::japanese;
  open_panel();
  EXPECT_GT(count("a.off"), 0u);
  laid_.session.preferences.language = Language::english;
  laid_.frames(3);
  press("Discard");
  EXPECT_TRUE(laid_.session.lost.empty());
  EXPECT_TRUE(state_.names().empty());
}

}  // namespace
}  // namespace ryosen
