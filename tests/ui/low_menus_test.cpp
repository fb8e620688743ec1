// Menus in a window that is too low for them: whole or scrolled within it, and away from the pointer.
#include <gtest/gtest.h>
#include <imgui_internal.h>  // where menus lie

#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "app/editor/preferences/panel_list.h"
#include "app/editor/session/session.h"
#include "app/editor/textbook/playing.h"
#include "app/ui/window_input.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/real_window.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

class LowMenus : public testing::Test, protected test::Laid {
 protected:
  static constexpr Size low{640, 480};
  LowMenus() : Laid("cube.obj", low) { input_.resize(low); }
  // Of the popup that is open.
  static ImRect popup() {
    const ImGuiWindow* const window = GImGui->OpenPopupStack.back().Window;
    return window ? window->Rect() : ImRect();
  }

  WindowInput input_{gui, session, {}, [this] { frames(4); }};
};

TEST_F(LowMenus, lie_below_the_bar_and_are_scrolled) {
  for (const MenuRow& row : menu_bar) {
    ASSERT_TRUE(session.run("menu " + std::string(row.id)).done()) << row.id;
    frames(5);
    ASSERT_GT(GImGui->OpenPopupStack.Size, 0) << row.id;
    EXPECT_GE(popup().Min.y, ImGui::FindWindowByName("##MainMenuBar")->Rect().Max.y - 1) << row.id;
    EXPECT_LE(popup().Max.y, low.height) << row.id;
    gui.close_menus();
    frames(3);
  }
}

// Of those that are nearly as high as the window.
TEST_F(LowMenus, that_are_hardly_too_long_are_whole) {
  for (const char* const language : {"language en", "language ja"}) {
    ASSERT_TRUE(session.run(language).done());
    for (const char* const menu : {"file", "edit", "add", "help"}) {
      ASSERT_TRUE(session.run("menu " + std::string(menu)).done());
      frames(5);
      ASSERT_GT(GImGui->OpenPopupStack.Size, 0) << menu;
      EXPECT_EQ(GImGui->OpenPopupStack.back().Window->ScrollMax.y, 0) << language << ", " << menu;
      gui.close_menus();
      frames(3);
    }
  }
}

TEST_F(LowMenus, of_help_show_the_names_of_all_exercises_and_figures) {
  ASSERT_TRUE(session.run("menu help").done());
  frames(5);
  EXPECT_LE(popup().Max.x, low.width);
  const test::DrawnText drawn(gui);
  for (const char* const text : {"Keysandmouse", "Exercises", "Acubewithtwothrough-holes", "Atriangularpyramid",
                                 "Figures2to7oftext002", "Figure7"})
    EXPECT_GE(drawn.count(text), 1u) << text;
  for (const std::string& shortened : drawn.shortened()) ADD_FAILURE() << shortened;
  input_.press(MouseButton::left, {drawn.place("Atriangularpyramid")});
  input_.release(MouseButton::left, {drawn.place("Atriangularpyramid")});
  frames(5);
  ASSERT_TRUE(session.shown.player());
}

TEST_F(LowMenus, of_an_element_lie_beside_the_pointer) {
  const glm::dvec2 pixels[] = {{320, 120}, {320, 300}, {480, 380}, {560, 90}, {290, 240}, {350, 240}};
  for (int i = 0; i < 36; ++i) {
    const glm::dvec2 pixel = pixels[i % 6];
    ASSERT_TRUE(session.run(i % 12 < 6 ? "language en" : "language ja").done());
    ASSERT_TRUE(session.run(i < 12 ? "mode face" : i < 24 ? "mode edge" : "mode vertex").done());
    if (i % 6 == 0) frames(3);
    input_.press(MouseButton::right, {pixel});
    input_.release(MouseButton::right, {pixel});
    frames(5);
    ASSERT_GT(GImGui->OpenPopupStack.Size, 0);
    const ImRect menu = popup();
    const std::string place =
        test::words_of({menu.Min.x, menu.Min.y}) + " to " + test::words_of({menu.Max.x, menu.Max.y});
    EXPECT_TRUE(menu.Min.x >= 0 && menu.Min.y >= 0 && menu.Max.x <= low.width && menu.Max.y <= low.height) << place;
    const auto is_at = [](double edge, double at) { return std::abs(edge - at) <= 2; };
    EXPECT_TRUE(is_at(menu.Min.x, pixel.x) || is_at(menu.Max.x, pixel.x) || is_at(menu.Min.y, pixel.y) ||
                is_at(menu.Max.y, pixel.y))
        << place << ", " << test::words_of(pixel);
    gui.close_menus();
    frames(3);
  }
}

// Those within menus are opened by the keyboard from each entry that has one.
TEST_F(LowMenus, within_menus_leave_the_names_around_them_to_be_read) {
  const bool is_long = test::is_long_run();
  const auto press = [&](const char* key, int frames_after) {
    input_.key_down(key);
    frames(is_long ? 2 : 1);
    input_.key_up(key);
    frames(is_long ? 4 : frames_after);
  };
  std::size_t opened = 0;
  ASSERT_TRUE(session.run("select f0").done());
  std::vector<int> all(34);
  std::iota(all.begin(), all.end(), 0);
  std::map<std::string, std::vector<int>> entries{{"edit", all}, {"select", all}, {"view", all}};
  for (const char* const language : {"language en", "language ja"}) {
    ASSERT_TRUE(session.run(language).done());
    for (auto& [menu, tried] : entries) {
      std::vector<int> with_menus;
      for (const int entry : tried) {
        ASSERT_TRUE(session.run("menu " + menu).done());
        frames(4);
        for (int i = 0; i < entry; ++i) press("Down", 1);
        press("Right", 5);
        if (GImGui->OpenPopupStack.Size == 2) {
          ++opened;
          with_menus.push_back(entry);
          const ImGuiWindow& around = *GImGui->OpenPopupStack[0].Window;
          const ImRect inner = popup();
          const std::string place = std::string(language) + " " + menu + " " + std::to_string(entry);
          const ImGuiMenuColumns& columns = around.DC.MenuColumns;
          const float names =
              around.Pos.x + around.WindowPadding.x + static_cast<float>(columns.OffsetLabel + columns.Widths[1]);
          EXPECT_GE(inner.Min.x, names) << place << ", " << inner.GetWidth() << " of " << around.Size.x;
          EXPECT_LE(inner.Max.x, low.width) << place;
        }
        gui.close_menus();
        frames(3);
      }
      if (!is_long) tried = with_menus;  // they should be the same in every language
    }
  }
  EXPECT_GT(opened, 30u);
}

}  // namespace
}  // namespace ryosen
