// The problems panel: a kind unfolds to its repairs and its elements; a press repairs, asks for a value, or goes there.
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>

#include "app/editor/words.h"
#include "core/analysis/problems.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;

class ProblemsPanel : public testing::Test, protected test::Laid {
 protected:
  ProblemsPanel() : Laid("cube.obj") {}

  // Unfolds a kind and clicks a row below it: its repairs come first, then its elements.
  void click_below(int kind, int row) {
    const double first = DrawnText(gui).place("Problems").y + 23;
    click({1080, first + 19 * kind});
    click({1030, first + 19 * (kind + 1 + row)});
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
  ASSERT_EQ(session.selection.size(), 3u) << "its loop";
  EXPECT_EQ(session.document().position(), 0u);
  EXPECT_EQ(session.selection[0].kind, Element::Kind::edge);
  EXPECT_NE(session.camera.eye, eye);
}

TEST_F(ProblemsPanel, a_press_on_a_quarantined_face_says_why_it_is_set_aside_and_its_line) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("aside.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 1\n");
  ASSERT_TRUE(session.run("open " + file_argument(path)).done());
  frames(3);
  const ProblemRow& kind = *std::find_if(problem_table().begin(), problem_table().end(), [](const ProblemRow& row) {
    return row.quarantined && row.quarantined(QuarantinedFace{1, 8, "repeated_corner", {0, 1, 1}, {}, {}}, 4);
  });
  click(DrawnText(gui).place("1" + std::string(kind.name_en)));
  click(DrawnText(gui).place("f1"));
  const std::string why =
      "Face f1 is set aside: it visits vertex v1 more than once. It has been since the file was read";
  EXPECT_EQ(gui.said().en, why + " (line 8).");
  EXPECT_NE(gui.said().ja, gui.said().en);
  frames(3);
  EXPECT_EQ(DrawnText(gui).count(gui.said().en), 2u) << "in the status line and beside the pointer";
}

}  // namespace
}  // namespace ryosen
