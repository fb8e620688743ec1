// Columns that scroll end with whole rows: no header, button or mark is cut by their ends, nor by what stays at the
// top.
#include <gtest/gtest.h>
#include <imgui_internal.h>  // what was drawn, and how far a column scrolls

#include <algorithm>
#include <string_view>

#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;

// How many triangles that are seen in the right column, as high as rows or lower, lie on both sides of a line.
int cut_triangles(float y, const ImGuiWindow& column) {
  const float em = ImGui::GetIO().Fonts->Fonts[0]->FontSize, free = 0.15f * em;
  int cut = 0;
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int n = 0; n < drawn.CmdListsCount; ++n) {
    const ImDrawList* const list = drawn.CmdLists[n];
    const std::string_view name = list->_OwnerName;
    if (!name.starts_with("##right") || name.starts_with("##right/held")) continue;
    for (const ImDrawCmd& command : list->CmdBuffer) {
      for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
        float first = 1e9f, last = -1e9f;
        bool is_seen = false;
        for (unsigned k = 0; k < 3; ++k) {
          const ImDrawVert& corner = list->VtxBuffer[list->IdxBuffer[static_cast<int>(command.IdxOffset + i + k)] +
                                                     static_cast<int>(command.VtxOffset)];
          first = std::min(first, corner.pos.y);
          last = std::max(last, corner.pos.y);
          is_seen |= (corner.col & IM_COL32_A_MASK) != 0 && corner.pos.x < column.InnerRect.Max.x;  // no scroll bar
        }
        cut += is_seen && last - first < 2 * em && first < y - free && last > y + free ? 1 : 0;
      }
    }
  }
  return cut;
}

// What lies over the upper end of the column.
bool is_held(const ImGuiWindow* window) {
  const std::string_view name = window->Name, begin = "##right/held";
  return window->WasActive && name.starts_with(begin) && name.find('/', begin.size()) == name.npos;
}

struct ColumnCase {
  Size size;
  float scale;
};

class ColumnEnds : public testing::TestWithParam<ColumnCase> {};

TEST_P(ColumnEnds, are_whole_rows_however_it_is_scrolled) {
  const auto [size, scale] = GetParam();
  test::Laid laid("fin.obj", size, scale);
  for (const char* const panel : {"colours", "levels", "growth", "records"})
    ASSERT_TRUE(laid.session.run("panel " + std::string(panel) + " on").done());
  laid.session.run("select v0");
  laid.gui.pointer({size.width - 60.0 * scale, 0.7 * size.height});
  laid.frames(4);
  const ImGuiWindow& column = *ImGui::FindWindowByName("##right");
  ASSERT_GT(column.ScrollMax.y, 100) << "it scrolls";
  int places = 0;
  float before = -1;
  for (float to = 0; to <= column.ScrollMax.y; to += 3.0f * scale, ++places) {
    ImGui::SetScrollY(const_cast<ImGuiWindow*>(&column), to);
    laid.frames(2);
    if (column.Scroll.y == before) break;
    before = column.Scroll.y;
    if (to == 0) {
      for (const char* const title : {"Underthepointer", "Inspector", "Problems"})
        EXPECT_EQ(DrawnText(laid.gui).count(title), 1u) << title << ": what is seen whole stays";
    }
    const auto held = std::find_if(GImGui->Windows.begin(), GImGui->Windows.end(), is_held);
    EXPECT_EQ(cut_triangles(column.Pos.y + column.Size.y, column), 0) << to;
    if (held != GImGui->Windows.end()) {
      EXPECT_EQ(cut_triangles((*held)->Pos.y + (*held)->Size.y, column), 0) << to;
    }
    EXPECT_EQ(DrawnText(laid.gui).cut_in_height(), "") << to;
  }
  EXPECT_GT(places, 30);
}

INSTANTIATE_TEST_SUITE_P(windows, ColumnEnds,
                         testing::Values(ColumnCase{{1280, 800}, 1}, ColumnCase{{1280, 661}, 1},
                                         ColumnCase{{2560, 1600}, 2}),
                         [](const auto& info) {
                           return std::to_string(info.param.size.width) + "x" + std::to_string(info.param.size.height);
                         });

}  // namespace
}  // namespace ryosen
