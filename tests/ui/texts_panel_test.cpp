// The index of the texts: what it shows is no change of anybody's, and comes also behind the question about changes.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "app/editor/textbook/text_places.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class TextsPanelTest : public testing::Test {
 protected:
  void take(std::string_view text) {
    ASSERT_TRUE(session().run("panel texts").done());
    laid_.frames(3);
    press(text);
  }
  void press(std::string_view text) {
    laid_.click(test::DrawnText(laid_.gui).last_place(text));
    laid_.frames(4);
  }
  bool asks() { return session().layout.open_panel == panel_opened_by(PanelOpener::loss).id; }
  Session& session() { return laid_.session; }

  test::Laid laid_{"fan.obj"};
};

TEST_F(TextsPanelTest, opens_an_entry_behind_the_question_about_changes) {
  ASSERT_TRUE(session().run("poke f0").done());
  take("Figure3:partsofapolygonmodel");
  ASSERT_TRUE(asks());
  press("Discard");
  EXPECT_FALSE(asks());
  EXPECT_EQ(session().mesh().live().faces, 4u);
  EXPECT_EQ(session().view.settings.numbers, Numbers::all) << "all of its lines";
  EXPECT_FALSE(session().document().is_modified());
  // Given up, it shows nothing, nor does the next question.
  ASSERT_TRUE(session().run("poke f0").done());
  const std::uint64_t hash = session().mesh().hash();
  take("Figure3:partsofapolygonmodel");
  ASSERT_TRUE(asks());
  press("Cancel");
  EXPECT_EQ(session().mesh().hash(), hash);
  laid_.gui.leave(session(), {});
  laid_.frames(3);
  press("Discard");
  EXPECT_EQ(session().mesh().live().faces, 0u);
}

TEST_F(TextsPanelTest, opens_an_entry_behind_a_save) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(session().run("open " + folder.copy(test::asset("cube.obj"), "a.obj")).done());
  ASSERT_TRUE(session().run("poke f0").done());
  const std::uint64_t hash = session().mesh().hash();
  take("Figure3:partsofapolygonmodel");
  ASSERT_TRUE(asks());
  press("Save");
  EXPECT_EQ(session().mesh().live().faces, 4u);
  EXPECT_NE(session().mesh().hash(), hash);
  EXPECT_EQ(Document::open(folder.at("a.obj")).value()->mesh().live().faces, 9u);
}

TEST_F(TextsPanelTest, shows_no_change) {
  for (const TextPlace& place : text_places()) {
    if (place.lines.empty()) continue;
    laid_.gui.leave(session(), {.command = "new; " + std::string(place.lines)});
    laid_.frames(2);
    EXPECT_FALSE(asks()) << place.lines;
    EXPECT_FALSE(session().document().is_modified()) << place.lines;
  }
  laid_.gui.leave(session(), {.quits = true});
  EXPECT_TRUE(laid_.gui.wants_quit());
}

TEST_F(TextsPanelTest, asks_for_what_is_edited_in_a_figure) {
  for (const char* line : {"figure 000-3", "figure 003-image22", "exercise cube", "exercise square"}) {
    SCOPED_TRACE(line);
    laid_.gui.leave(session(), {.command = "new"});
    laid_.frames(2);
    ASSERT_TRUE(session().run(line).done());
    EXPECT_FALSE(session().document().is_modified());
    ASSERT_TRUE(session().run("undo").done());
    EXPECT_FALSE(session().document().is_modified()) << "to look back is no change either";
    ASSERT_TRUE(session().run("redo").done());
    EXPECT_FALSE(session().document().is_modified());
    ASSERT_TRUE(session().run("move_vertex v0 9,9,9").done());
    EXPECT_TRUE(session().document().is_modified());
    laid_.gui.leave(session(), {});
    EXPECT_TRUE(asks());
    ASSERT_TRUE(session().run("panel none").done());
    ASSERT_TRUE(session().run("undo").done());
    EXPECT_FALSE(session().document().is_modified());
  }
  // An edit in place of what was undone.
  ASSERT_TRUE(session().run("undo 2").done());
  ASSERT_TRUE(session().run("make_vertex 5,5,5").done());
  EXPECT_TRUE(session().document().is_modified());
}

TEST_F(TextsPanelTest, what_is_saved_of_a_figure_is_a_file_like_any) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(session().run("new").done());
  ASSERT_TRUE(session().run("figure 000-3").done());
  ASSERT_TRUE(session().run("poke f0").done());
  ASSERT_TRUE(session().run("save " + folder.at("a.obj")).done());
  EXPECT_FALSE(session().document().is_modified());
  ASSERT_TRUE(session().run("undo").done());
  EXPECT_TRUE(session().document().is_modified()) << "the file holds more";
}

}  // namespace
}  // namespace ryosen
