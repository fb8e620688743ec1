// Tab and Shift+Tab in what lies over the view: through all that can be pressed or written into, and what has the
// keyboard is marked; Enter presses that and nothing else.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // who has the keyboard

#include <algorithm>
#include <vector>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class TabKey : public testing::Test, protected test::Laid {
 protected:
  TabKey() : Laid("cube.obj") {}

  void press(int key, bool shift = false) {
    gui.modifiers(shift, false);
    gui.key(key, true);
    gui.key(key, false);
    frames(4);
    gui.modifiers(false, false);
  }
  void show(const std::string& panel) {
    ASSERT_TRUE(session.run("panel " + panel).done());
    frames(4);
  }
  void edit(const std::string& file) {
    ASSERT_TRUE(session.run("open " + file).done());
    ASSERT_TRUE(session.run("move_vertex v0 9,9,9").done());
  }
  static bool is_marked() {
    return GImGui->NavId == GImGui->ActiveId || (GImGui->NavIdIsAlive && !GImGui->NavDisableHighlight);
  }
  // All that has the keyboard in turn, from the first that Tab comes to until it comes there again.
  std::vector<ImGuiID> round(bool shift = false) {
    std::vector<ImGuiID> ids;
    for (int i = 0; i < 200; ++i) {
      press(ImGuiKey_Tab, shift);
      EXPECT_TRUE(is_marked()) << i;
      if (!ids.empty() && GImGui->NavId == ids.front()) return ids;
      ids.push_back(GImGui->NavId);
    }
    ADD_FAILURE() << "it does not come back";
    return ids;
  }

  test::TemporaryFolder folder_;
};

TEST_F(TabKey, goes_to_the_button_that_enter_presses_then) {
  const std::string file = folder_.copy(test::asset("cube.obj"), "cube.obj"), before = test::read_file(file);
  for (const bool backwards : {false, true}) {
    edit(file);
    gui.leave(session, {false, {}});
    frames(4);
    press(ImGuiKey_Tab, backwards);
    if (backwards) press(ImGuiKey_Tab, true);  // from Save to Cancel to Discard
    press(ImGuiKey_Enter);
    EXPECT_EQ(test::read_file(file), before) << "to discard is not to save";
    EXPECT_EQ(session.mesh().live().vertices, 0u) << "it went on";
  }
  edit(file);
  gui.leave(session, {false, {}});
  frames(4);
  press(ImGuiKey_Enter);
  EXPECT_NE(test::read_file(file), before) << "the first button saves";
}

TEST_F(TabKey, comes_to_later_behind_what_is_to_be_recovered) {
  LostSession lost;
  lost.file = "lost.obj";
  session.lost = {lost};
  gui.run(session, "panel recover");
  frames(4);
  session.lost = {lost};
  frames(4);
  EXPECT_EQ(round().size(), 3u) << "Recover, Discard, Later";
}

TEST_F(TabKey, goes_through_all_fields_lists_boxes_and_buttons_and_back) {
  ASSERT_TRUE(session.run("values simplify").done());
  frames(4);
  std::size_t fields = 0;
  for (const ParameterRow& row : find_algorithm("simplify")->parameters)
    fields += row.kind == ParameterKind::elements ? 2 : 1;
  std::vector<ImGuiID> ids = round();
  EXPECT_GE(ids.size(), fields + 1) << "and Preview, and Run where all is there";
  std::vector<ImGuiID> back = round(true);
  std::sort(ids.begin(), ids.end());
  std::sort(back.begin(), back.end());
  EXPECT_EQ(ids, back);
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end()) << "each once";
}

TEST_F(TabKey, leaves_every_panel_where_enter_presses_what_is_marked) {
  for (const PanelRow& row : panel_list()) {
    if (row.place != PanelPlace::over || row.opened_by == PanelOpener::loss) continue;
    show(std::string(row.id));
    EXPECT_GE(round().size(), 1u) << row.id;
    ASSERT_TRUE(session.run("panel none").done());
    frames(4);
  }
}

// The list is of the folder that a path has come to.
TEST_F(TabKey, goes_into_the_folder_whose_name_it_completes) {
  const std::filesystem::path folder = folder_.path() / "meshes" / "small";
  std::filesystem::create_directories(folder);
  std::filesystem::copy(test::asset("cube.obj"), folder / "a_cube.obj");
  show("open");
  gui.text(folder_.path().string() + "/me");
  frames(3);
  press(ImGuiKey_Tab);
  EXPECT_EQ(test::DrawnText(gui).count("small/"), 1u) << "the only folder that begins so";
  gui.text("sm");
  frames(3);
  press(ImGuiKey_Tab);
  EXPECT_EQ(test::DrawnText(gui).count("a_cube.obj"), 1u);
  gui.text("../");
  frames(3);
  press(ImGuiKey_Tab);
  EXPECT_EQ(test::DrawnText(gui).count("small/"), 1u) << "one that was written whole, too";
  press(ImGuiKey_DownArrow);
  press(ImGuiKey_Tab);
  EXPECT_EQ(test::DrawnText(gui).count("a_cube.obj"), 1u) << "and one that was chosen";
  gui.text("a_c");
  frames(3);
  press(ImGuiKey_Tab);
  press(ImGuiKey_Enter);
  EXPECT_EQ(session.document().path(), folder / "a_cube.obj");
}

TEST_F(TabKey, completes_the_name_of_a_file_and_goes_on_from_it) {
  ASSERT_TRUE(session.run("open " + folder_.copy(test::asset("cube.obj"), "lonely.obj")).done());
  show("open");
  gui.character('l');
  frames(2);
  EXPECT_EQ(test::DrawnText(gui).count("lonely.obj"), 2u);
  const ImGuiID field = GImGui->ActiveId;
  press(ImGuiKey_Tab);
  EXPECT_EQ(GImGui->ActiveId, field);
  EXPECT_EQ(test::DrawnText(gui).count("lonely.obj"), 3u) << "in the title, in the list and in the field";
  press(ImGuiKey_Tab);
  EXPECT_EQ(GImGui->ActiveId, 0u) << "a button has the keyboard";
  EXPECT_TRUE(is_marked());
  EXPECT_EQ(session.layout.open_panel, "open") << "and is not pressed";
}

}  // namespace
}  // namespace ryosen
