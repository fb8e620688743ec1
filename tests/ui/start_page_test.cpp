// What lies over the empty view, by mouse and by keys.
#include "app/ui/start_page.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>  // how far it scrolls

#include <fstream>

#include "app/editor/session/session.h"
#include "app/editor/textbook/exercises.h"
#include "app/ui/headless.h"
#include "app/ui/window_input.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class StartPageTest : public testing::Test, protected test::Laid {
 protected:
  StartPageTest() : Laid("cube.obj", {1280, 800}) {
    input_.resize(size_);
    start();
  }
  void start() {
    ASSERT_TRUE(gui.run(session, "start").done());
    frames(4);
  }
  bool has(std::string_view text) const { return test::DrawnText(gui).count(text) > 0; }
  void take(std::string_view text) {
    click(test::DrawnText(gui).place(text));
    frames(4);
  }
  void key(const std::string& chord) {
    EXPECT_TRUE(input_.key(chord).done()) << chord;
    frames(3);
  }

  WindowInput input_{gui, session, [this] { frames(1); }};
};

TEST_F(StartPageTest, offers_shapes_and_goes_away_once_there_is_a_mesh) {
  ASSERT_TRUE(has("ordropafilehere"));
  for (const char* told : {"Undo:Ctrl+Z", "Save:Ctrl+S", "pressCtocollapse", "pressG,move,click"})
    EXPECT_TRUE(has(told)) << told;
  take("Dodecahedron");
  EXPECT_EQ(session.mesh().live().faces, 12u);
  EXPECT_FALSE(has("ordropafilehere"));
  ASSERT_TRUE(session.run("undo").done());
  frames(3);
  EXPECT_FALSE(has("Dodecahedron")) << "a history is something";
}

TEST_F(StartPageTest, new_is_an_empty_mesh_without_it) {
  take("New,anemptymesh");
  EXPECT_FALSE(has("New,anemptymesh"));
  start();
  EXPECT_TRUE(has("ordropafilehere"));
}

// Where nothing is, the view says quietly what can be.
TEST_F(StartPageTest, an_empty_view_says_how_to_go_on) {
  const auto hint = [&] { return has("ThemenuAddmakesashape,") && has("ordropafilehere"); };
  ASSERT_FALSE(hint());
  ASSERT_TRUE(gui.run(session, "new").done());
  frames(3);
  EXPECT_TRUE(hint());
  EXPECT_FALSE(gui.owns_pointer(session.layout, size_, test::DrawnText(gui).place("ordropafilehere")));
  session.frontend.awaits_file = true;
  frames(3);
  EXPECT_FALSE(hint()) << "a file is read";
  session.frontend.awaits_file = false;
  ASSERT_TRUE(session.run("bind Ctrl+M menu add").done());
  frames(3);
  EXPECT_TRUE(has("ThemenuAdd(Ctrl+M)makesashape,")) << "with its key";
  ASSERT_TRUE(gui.run(session, "cube").done());
  frames(3);
  EXPECT_FALSE(has("ordropafilehere"));
  ASSERT_TRUE(session.run("undo").done());
  frames(3);
  EXPECT_TRUE(has("ordropafilehere"));
}

TEST_F(StartPageTest, open_opens_the_browser_and_comes_back_when_that_is_left) {
  take("Open...");
  EXPECT_EQ(session.layout.open_panel, "open");
  EXPECT_FALSE(has("ordropafilehere"));
  key("Escape");
  EXPECT_TRUE(has("ordropafilehere"));
}

TEST_F(StartPageTest, every_exercise_is_built_in_steps_and_holds_what_it_expects) {
  for (const ExerciseScript& exercise : exercise_scripts()) {
    start();
    std::string name_drawn;
    for (const char c : name_of_exercise(exercise).en)
      if (c != ' ') name_drawn += c;
    take(name_drawn);
    EXPECT_GT(session.document().history().size(), 3u) << exercise.id;
    EXPECT_GT(session.mesh().live().faces, 0u);
    const Text name = name_of_exercise(exercise);
    EXPECT_NE(name.en, "") << exercise.id;
    EXPECT_NE(name.ja, name.en) << exercise.id;
    EXPECT_EQ(session.run("exercise " + std::string(exercise.id)).exit_code, ExitCode::refused) << "not on a mesh";
  }
  EXPECT_EQ(session.run("exercise nonsense").exit_code, ExitCode::usage);
}

TEST_F(StartPageTest, arrows_choose_and_enter_takes) {
  key("Down");   // shows where it is: at New
  key("Right");  // to the first shape
  key("Right");
  key("Enter");
  EXPECT_EQ(session.mesh().live().faces, 6u) << "the cube";
  EXPECT_EQ(session.document().history().size(), 1u);
  EXPECT_FALSE(input_.key("Up").done()) << "it has its usual meaning again: nothing is selected to walk from";
}

// A menu of the bar takes the arrows and Enter alone: both did what was chosen.
TEST_F(StartPageTest, leaves_the_keys_to_a_menu_that_is_open) {
  key("Down");  // shows where it is
  for (const char* const chord : {"F10", "Right", "Down", "Down"}) key(chord);
  key("Enter");
  EXPECT_NE(session.selecting.tool, "") << "an entry of Edit";
  EXPECT_TRUE(session.document().history().empty()) << "no shape";
  EXPECT_TRUE(session.is_at_start());
}

TEST_F(StartPageTest, lists_recent_files_and_says_which_are_gone) {
  test::TemporaryFolder folder;
  session.preferences.recent = {folder.copy(test::asset("torus.off"), "a torus.off"), folder.at("gone.off")};
  frames(3);
  EXPECT_TRUE(has("gone.off(notthereanymore)"));
  take("gone.off");
  EXPECT_TRUE(session.is_at_start()) << "nothing happens, nothing is broken";
  take("atorus.off");
  EXPECT_EQ(session.document().path(), folder.at("a torus.off"));
}

TEST_F(StartPageTest, cuts_nothing_in_either_language_and_in_small_windows) {
  for (const Size size : {Size{1280, 800}, Size{640, 480}})
    for (const char* const language : {"language en", "language ja"}) {
      size_ = size;
      session.preferences.recent.assign(10, test::asset("torus.off"));
      ASSERT_TRUE(session.run(language).done());
      frames(4);
      const test::DrawnText text(gui);
      EXPECT_EQ(text.cut_sideways(), "") << size.width << language;
      EXPECT_EQ(text.overlapping(), "") << size.width << language;
    }
}

TEST_F(StartPageTest, has_its_parts_behind_tabs_in_a_small_window_and_hides_nothing_below) {
  size_ = {640, 480};
  session.preferences.recent.assign(10, test::asset("torus.off"));
  const auto is_whole = [&](const char* what) {
    frames(4);
    EXPECT_EQ(ImGui::FindWindowByName("##start")->ScrollMax.y, 0) << what;
    EXPECT_EQ(test::DrawnText(gui).cut_in_height() + test::DrawnText(gui).cut_sideways(), "") << what;
    EXPECT_EQ(test::DrawnText(gui).overlapping(), "") << what;
  };
  ASSERT_TRUE(session.run("language ja").done());
  is_whole("Japanese");
  ASSERT_TRUE(session.run("language en").done());
  for (const char* const part : {"Shapes", "Exercises", "Figures", "Files"}) {
    frames(4);
    take(part);
    is_whole(part);
    for (const char* told : {"Undo:Ctrl+Z", "Save:Ctrl+S", "pressCtocollapse"}) EXPECT_TRUE(has(told)) << part;
  }
  EXPECT_TRUE(has("New,anemptymesh"));
  take("Shapes");
  EXPECT_FALSE(has("New,anemptymesh"));
  take("Octahedron");
  EXPECT_EQ(session.mesh().live().faces, 8u);
}

TEST_F(StartPageTest, keys_go_through_the_tabs_too) {
  size_ = {640, 480};
  frames(4);
  key("Right");  // shows where it is: at the first tab
  key("Right");
  key("Enter");
  EXPECT_TRUE(has("Octahedron"));
  key("Down");
  key("Enter");
  EXPECT_GT(session.mesh().live().faces, 0u);
}

TEST(start_page, is_in_pictures_with_panels_only) {
  Headless::Options options;
  options.size = {640, 480};
  const auto differs = [&](bool panels) {
    options.panels = panels;
    auto headless = Headless::make(options);
    EXPECT_TRUE(headless);
    Session session(std::make_unique<Document>());
    (*headless)->place_view(session);
    const Image with = (*headless)->picture(session);
    session.frontend.begins_empty = true;
    return with.pixels != (*headless)->picture(session).pixels;
  };
  EXPECT_TRUE(differs(true));
  EXPECT_FALSE(differs(false));
}

}  // namespace
}  // namespace ryosen
