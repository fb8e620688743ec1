// The problems panel: a kind unfolds to its repairs and its elements; a press repairs, asks for a value, or goes there.
#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class ProblemsPanel : public testing::Test, protected test::Laid {
 protected:
  ProblemsPanel() : Laid("cube.obj") {}

  // Unfolds a kind and clicks a row below it: its repairs come first, then its elements.
  void click_below(int kind, int row) {
    click({1080, 170 + 19 * kind});
    click({1030, 170 + 19 * (kind + 1 + row)});
  }
};

TEST_F(ProblemsPanel, a_press_on_a_repair_does_it_and_undo_takes_it_back) {
  open("duplicate_face.obj");
  ASSERT_EQ(session.mesh().live().faces, 2u);
  click_below(1, 0);
  ASSERT_EQ(session.document().position(), 1u) << "one entry of the history";
  EXPECT_EQ(session.document().history()[0].command, "repair remove_duplicates");
  EXPECT_EQ(session.mesh().live().faces, 1u);
  EXPECT_TRUE(gui.said().en.starts_with("repair remove_duplicates: ")) << gui.said().en;
  EXPECT_NE(gui.said().ja, gui.said().en);
  ASSERT_TRUE(session.run("undo").done());
  frames(2);
  EXPECT_EQ(session.mesh().live().faces, 2u);
}

TEST_F(ProblemsPanel, a_repair_that_needs_a_value_opens_its_field) {
  open("moebius.off");
  click_below(1, 1);
  ASSERT_EQ(session.open_panel, "values");
  EXPECT_EQ(session.document().position(), 0u) << "nothing was done yet";
  frames(3);
  for (const char c : std::string_view("0.001")) gui.character(static_cast<unsigned>(c));
  frames(1);
  gui.key(ImGuiKey_Enter, true);
  gui.key(ImGuiKey_Enter, false);
  frames(3);
  EXPECT_TRUE(gui.said().en.starts_with("weld_close distance=0.001: ")) << gui.said().en;
  EXPECT_EQ(session.open_panel, "");
}

TEST_F(ProblemsPanel, a_press_on_an_element_selects_it_and_goes_there) {
  open("duplicate_face.obj");
  const glm::dvec3 eye = session.camera.eye;
  click_below(0, 2);
  ASSERT_EQ(session.selection.size(), 1u);
  EXPECT_EQ(session.document().position(), 0u);
  EXPECT_EQ(session.selection[0].kind, Element::Kind::edge);
  EXPECT_NE(session.camera.eye, eye);
}

}  // namespace
}  // namespace ryosen
