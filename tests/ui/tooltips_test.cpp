// Whatever can be pressed in the columns says in a sentence what it is: totals, highlights, modes, tools, buttons,
// lists.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // what is hovered, and which windows are tooltips

#include <set>

#include "app/editor/input/pick_modes.h"
#include "app/editor/preferences/preferences.h"
#include "app/editor/preferences/view_switches.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/ops/all.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using test::DrawnText;
using test::Laid;

bool is_told() {
  for (const ImGuiWindow* const one : GImGui->Windows)
    if (one->Active && (one->Flags & ImGuiWindowFlags_Tooltip) != 0) return true;
  return false;
}

bool is_scrollbar(ImGuiID id) {
  ImGuiWindow* const under = GImGui->HoveredWindow;
  return under != nullptr && (id == ImGui::GetWindowScrollbarID(under, ImGuiAxis_X) ||
                              id == ImGui::GetWindowScrollbarID(under, ImGuiAxis_Y));
}

// Where something that can be pressed tells nothing, by window and pixel.
std::set<std::string> untold_in_columns(Laid& laid, Size size) {
  std::set<std::string> untold;
  const PixelRect view = laid.gui.view_area(size, laid.session.layout);
  std::set<ImGuiID> seen;
  for (double y = view.y0 + 3; y < view.y1; y += test::is_long_run() ? 7 : 21)
    for (const double x : {40.0, view.x0 - 60.0, view.x1 + 16.0, view.x1 + 90.0, size.width - 50.0}) {
      laid.gui.pointer({x, y});
      laid.frames(2);
      const ImGuiID hovered = GImGui->HoveredId;
      if (hovered == 0 || is_scrollbar(hovered) || is_told() || !seen.insert(hovered).second) continue;
      untold.insert(std::string(GImGui->HoveredWindow != nullptr ? GImGui->HoveredWindow->Name : "?") + " at " +
                    std::to_string(static_cast<int>(x)) + "," + std::to_string(static_cast<int>(y)));
    }
  return untold;
}

TEST(tooltips, stand_at_everything_that_can_be_pressed_in_the_columns) {
  Laid laid("three_tri_edge.off", test::tall_window);
  for (const char* const line : {"select v0", "poke f0", "undo", "hide f1"})
    ASSERT_TRUE(laid.session.run(line).done()) << line;
  for (const char* const language : {"language en", "language ja"}) {
    ASSERT_TRUE(laid.session.run(language).done());
    laid.frames(3);
    EXPECT_EQ(untold_in_columns(laid, test::tall_window), std::set<std::string>()) << language;
  }
}

// What a tooltip says comes from the tables: no row may be without its sentence in either language.
TEST(tooltips, have_a_sentence_in_every_row_of_the_tables) {
  const auto tells = [](std::string_view id, std::string_view en, std::string_view ja) {
    EXPECT_GT(en.size(), 8u) << id;
    EXPECT_GT(ja.size(), 8u) << id;
    EXPECT_NE(en, ja) << id;
  };
  for (const HighlightRow& row : highlight_table()) tells(row.id, row.legend_en, row.legend_ja);
  for (const PickModeRow& row : pick_modes) tells(row.id, row.help_en, row.help_ja);
  for (const OpInfo& op : all_ops()) tells(op.id, op.help_en, op.help_ja);
  for (const OpGroupRow& group : op_groups()) tells(group.en, group.help_en, group.help_ja);
  for (const PanelRow& row : panel_list()) tells(row.id, row.help_en, row.help_ja);
  for (const ViewSwitch& row : view_switches()) tells(row.id, row.help_en, row.help_ja);
  for (const PreferenceRow& row : preference_table()) tells(row.field.id, row.field.help_en, row.field.help_ja);
  for (const ColourMap& map : colour_maps()) tells(map.id, map.legend_en, map.legend_ja);
  for (const AlgorithmRow& row : algorithm_table()) tells(row.id, row.help_en, row.help_ja);
}

TEST(tooltips, say_what_each_letter_of_the_sum_counts) {
  Laid laid("cube.obj", test::tall_window);
  for (const EulerTerm& term : euler_letters()) {
    if (term.is_rare) continue;
    laid.gui.pointer(DrawnText(laid.gui).place(term.en));
    laid.frames(3);
    EXPECT_TRUE(is_told()) << term.letter;
  }
}

// The tooltip that lies over an item of the window under the pointer, or over one a row above or below that.
std::string covered_neighbour(const Laid& laid) {
  const ImGuiWindow* const under = GImGui->HoveredWindow;
  if (!under) return "";
  const ImVec2 at = ImGui::GetIO().MousePos;
  const float row = ImGui::GetFrameHeightWithSpacing();
  const ImRect panel = under->RootWindow->Rect();
  const ImRect near(panel.Min.x, at.y - row, panel.Max.x, at.y + row), all(ImVec2(0, 0), ImGui::GetIO().DisplaySize);
  for (const ImGuiWindow* const one : GImGui->Windows)
    if (one->Active && !one->Hidden && (one->Flags & ImGuiWindowFlags_Tooltip) != 0 &&
        (near.Overlaps(one->Rect()) || !all.Contains(one->Rect())))
      return std::string(under->Name) + " " + laid.session.layout.flyout + " at " + std::to_string(int(at.x)) + "," +
             std::to_string(int(at.y)) + "; ";
  return "";
}

TEST(tooltips, cover_neither_the_row_above_nor_the_one_below_in_any_window) {
  for (const Size size : {Size{640, 480}, Size{1280, 800}}) {
    Laid laid("fin.obj", size);
    std::size_t told = 0;
    int looked = 0;
    const auto look = [&](const std::string& what) {
      laid.frames(4);
      std::string covered;
      // A short run looks at every fifth place, which are others in the next panel.
      const int every = test::is_long_run() ? 1 : 5;
      for (double y = 30 + 17 * (looked++ % every); y < size.height - 25; y += 17 * every)
        for (const double x : {0.12, 0.45, 0.8}) {
          laid.gui.pointer({std::floor(x * size.width), y});
          laid.frames(2);
          told += is_told() ? 1 : 0;
          covered += covered_neighbour(laid);
        }
      EXPECT_EQ(covered, "") << what << " " << size.width;
    };
    for (const char* const language : {"language en", "language ja"}) {
      laid.open("fin.obj");
      ASSERT_TRUE(laid.session.run(language).done());
      for (const PanelRow& row : panel_list()) {
        const bool asks = row.opened_by == PanelOpener::asked_values;
        ASSERT_TRUE(laid.session.run(asks ? "values simplify" : "panel " + std::string(row.id) + " on").done());
        if (row.place == PanelPlace::over || size.width < 900) look(std::string(row.id) + " " + language);
        ASSERT_TRUE(laid.session.run("panel none").done());
      }
      ASSERT_TRUE(laid.session.run("start").done());
      look(std::string("start page ") + language);
    }
    EXPECT_GT(told, 40u) << "there are any";
  }
}

// Whoever goes through a window by the keyboard reads the next rows, on both sides.
// What a tab has opened tells beside itself, and not over the tabs at the other side.
TEST(tooltips, leave_the_tabs_at_the_other_side_free) {
  const Size size{640, 480};
  Laid laid("fin.obj", size);
  std::size_t told = 0;
  for (const char* const panel : {"problems", "highlights", "totals", "tools"}) {
    ASSERT_TRUE(laid.session.run("panel " + std::string(panel) + " flyout").done());
    laid.frames(4);
    const ImRect open = ImGui::FindWindowByName("##flyout")->Rect();
    for (float y = open.Min.y + 4; y < open.Max.y; y += 9) {
      laid.gui.pointer({(open.Min.x + open.Max.x) / 2, y});
      laid.frames(3);
      for (const ImGuiWindow* const one : GImGui->Windows) {
        if (!one->Active || one->Hidden || (one->Flags & ImGuiWindowFlags_Tooltip) == 0) continue;
        ++told;
        for (const char* const strip : {"##left", "##right"})
          EXPECT_FALSE(one->Rect().Overlaps(ImGui::FindWindowByName(strip)->Rect())) << panel << " at " << y;
      }
    }
  }
  EXPECT_GT(told, 20u);
}

TEST(tooltips, of_what_has_the_keyboard_lie_three_rows_away) {
  Laid laid("cube.obj", {640, 480});
  ASSERT_TRUE(laid.session.run("panel preferences").done());
  laid.frames(4);
  std::size_t told = 0;
  for (std::size_t i = 0; i + 1 < preference_table().size(); ++i) {
    laid.gui.key(ImGuiKey_DownArrow, true);
    laid.frames(1);
    laid.gui.key(ImGuiKey_DownArrow, false);
    laid.frames(3);
    const ImGuiWindow& list = *GImGui->NavWindow;
    const ImRect item = list.NavRectRel[ImGuiNavLayer_Main];
    const float row = ImGui::GetFrameHeightWithSpacing(), first = list.Pos.y + item.Min.y - 2.5f * row,
                last = list.Pos.y + item.Max.y + 2.5f * row;
    for (const ImGuiWindow* const one : GImGui->Windows) {
      if (!one->Active || one->Hidden || (one->Flags & ImGuiWindowFlags_Tooltip) == 0) continue;
      ++told;
      EXPECT_TRUE(one->Rect().Max.y <= first || one->Rect().Min.y >= last) << i;
      EXPECT_LE(one->Rect().Max.y, 480) << i;
    }
  }
  EXPECT_GT(told, 5u);
}

TEST(totals, say_why_a_mesh_has_more_vertices_than_points) {
  Laid laid("three_tri_edge.off", test::tall_window);
  const auto held = [&](const char* text) { return DrawnText(laid.gui).count(text); };
  const std::string vertices = std::to_string(laid.session.mesh().live().vertices);
  EXPECT_EQ(held(("5 points, held as " + vertices + " vertices").c_str()), 1u);
  laid.open("cube.obj");
  EXPECT_EQ(held("held as"), 0u);
}

}  // namespace
}  // namespace ryosen
