// The panel of forms: it measures when its button is pressed, never by itself, and says when the mesh has changed
// since.
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class FormsPanel : public testing::Test, protected test::Laid {
 protected:
  FormsPanel() : Laid("torus.off", test::tall_window) {}

  void press_measure() {
    click_on(session.preferences.language == Language::english ? "Measure" : "測る");
    gui.pointer({640, 1300});
    frames(2);
  }
  int drawn() const { return gui.draw_data().TotalVtxCount; }
};

TEST_F(FormsPanel, measures_only_when_asked) {
  const int before = drawn();
  frames(5);
  EXPECT_EQ(drawn(), before);
  press_measure();
  EXPECT_GT(drawn(), before + 2000) << "a row per form and method";
}

TEST_F(FormsPanel, says_that_the_mesh_has_changed_and_forgets_another_document) {
  const int empty = drawn();
  press_measure();
  const int measured = drawn();
  ASSERT_TRUE(session.run("split 0-1").done());
  ASSERT_TRUE(session.run("undo").done());
  frames(2);
  EXPECT_NE(drawn(), measured) << "a sentence more";
  EXPECT_GT(drawn(), empty + 2000) << "the figures stay";
  ASSERT_TRUE(session.run("open " + test::asset("torus.off")).done());
  frames(3);
  EXPECT_LT(drawn(), empty + 1000);
}

TEST_F(FormsPanel, speaks_japanese) {
  ASSERT_TRUE(session.run("language ja").done());
  frames(3);
  const int before = drawn();
  press_measure();
  EXPECT_GT(drawn(), before + 1500);
}

}  // namespace
}  // namespace ryosen
