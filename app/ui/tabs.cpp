#include <algorithm>
#include <cmath>
#include <span>

#include "app/editor/preferences/layout.h"
#include "app/ui/side_columns.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// Draws text turned by a quarter about the middle of a rectangle: upwards at the left side, downwards at the right.
void turned_text(ImVec2 middle, const std::string& text, ImU32 colour, bool upwards) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const int first = list.VtxBuffer.Size;
  // In the middle of the whole window while it lies, so that no letter falls to a border of the clipping.
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const ImVec2 at{std::floor((all.x - size.x) / 2), std::floor((all.y - size.y) / 2)};
  list.PushClipRectFullScreen();
  list.AddText(at, colour, text.c_str());
  list.PopClipRect();
  const ImVec2 centre{at.x + std::floor(size.x / 2), at.y + std::floor(size.y / 2)};
  const ImVec2 target{std::floor(middle.x), std::floor(middle.y)};
  for (int i = first; i < list.VtxBuffer.Size; ++i) {
    ImVec2& place = list.VtxBuffer[i].pos;
    const ImVec2 from{place.x - centre.x, place.y - centre.y};
    place = upwards ? ImVec2{target.x + from.y, target.y - from.x} : ImVec2{target.x - from.y, target.y + from.x};
  }
}

// How many tabs of these heights have room one below the other, with gaps between them; where that is not all, beside
// one more of that height.
std::size_t tabs_with_room(const std::vector<float>& heights, float room, float gap, float last) {
  float used = gap;
  std::size_t fitting = 0, beside_last = 0;
  while (fitting < heights.size() && used + heights[fitting] + gap <= room) {
    used += heights[fitting++] + gap;
    if (used + last + gap <= room) beside_last = fitting;
  }
  return fitting == heights.size() ? fitting : beside_last;
}

// The button of a tab, with what it has to say upright beside it. True when it was clicked.
bool draw_strip(PanelContext& context, PanelPlace side, ImVec2 size, bool is_open) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool is_clicked = ImGui::InvisibleButton("tab", size);
  const ImGuiCol fill = is_open                  ? ImGuiCol_FrameBgActive
                        : ImGui::IsItemHovered() ? ImGuiCol_HeaderHovered
                                                 : ImGuiCol_Header;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(fill), ImGui::GetStyle().FrameRounding);
  if (is_open) {
    const float mark = 3 * context.scale, x = side == PanelPlace::left ? at.x + size.x - mark : at.x;
    list.AddRectFilled({x, at.y + 2}, {x + mark, at.y + size.y - 2}, ImGui::GetColorU32(context.colours().accent), 2);
  }
  return is_clicked;
}

bool is_open(const PanelContext& context, const PanelRow& row) { return context.layout.flyout == row.id; }

// Opens the panel, or closes it where it is open.
std::string line_of_click(const PanelContext& context, const PanelRow& row) {
  return is_open(context, row) ? "panel none" : "panel " + std::string(row.id) + " flyout";
}

void draw_tab(PanelContext& context, PanelPlace side, const PanelRow& row, ImVec2 size, float letters) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool was_open = is_open(context, row);
  ImGui::PushID(row.id.data(), row.id.data() + row.id.size());
  if (draw_strip(context, side, size, was_open)) context.run(line_of_click(context, row));
  turned_text({at.x + size.x / 2, at.y + size.y / 2}, fitted(context.short_title(row), letters),
              ImGui::GetColorU32(ImGuiCol_Text), side == PanelPlace::left);
  if (!was_open) tip(context.title(row));
  ImGui::PopID();
}

// The tab of those that have no room: how many they are, and a menu of them.
void draw_rest(PanelContext& context, PanelPlace side, std::span<const PanelRow* const> rest, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool has_open =
      std::any_of(rest.begin(), rest.end(), [&](const PanelRow* row) { return is_open(context, *row); });
  ImGui::PushID("rest");
  if (draw_strip(context, side, size, has_open)) ImGui::OpenPopup("menu");
  const std::string number = "+" + std::to_string(rest.size());
  const ImVec2 text = ImGui::CalcTextSize(number.c_str());
  ImGui::GetWindowDrawList()->AddText(
      {at.x + std::floor((size.x - text.x) / 2), at.y + std::floor((size.y - text.y) / 2)},
      ImGui::GetColorU32(ImGuiCol_Text), number.c_str());
  tip(context.text("The panels that have no room for a tab.", "タブが入りきらないパネルの一覧です。"));
  if (ImGui::BeginPopup("menu")) {
    for (const PanelRow* const row : rest)
      if (ImGui::MenuItem(context.title(*row), nullptr, is_open(context, *row)))
        context.run(line_of_click(context, *row));
    ImGui::EndPopup();
  }
  ImGui::PopID();
}

// Down the strip, with gaps between them; those that have no room behind the last.
void draw_strip_of(PanelContext& context, PanelPlace side, std::span<const PanelRow* const> rows, ImVec2 all,
                   float gap) {
  const float ends = 9 * context.scale, line = ImGui::GetTextLineHeight() + 2 * ends, width = all.x - 2 * gap;
  const float longest = std::max(all.y - line - 3 * gap, 1.f);
  std::vector<float> heights;
  for (const PanelRow* const row : rows)
    heights.push_back(std::min(std::floor(ImGui::CalcTextSize(context.short_title(*row)).x + 2 * ends), longest));
  const std::size_t with_tab = tabs_with_room(heights, all.y, gap, line);
  float y = gap;
  for (std::size_t i = 0; i < with_tab; ++i) {
    ImGui::SetCursorPos({gap, y});
    draw_tab(context, side, *rows[i], {width, heights[i]}, heights[i] - ends);
    y += heights[i] + gap;
  }
  if (with_tab == rows.size()) return;
  ImGui::SetCursorPos({gap, y});
  draw_rest(context, side, rows.subspan(with_tab), {width, line});
}

}  // namespace

void draw_tabs(PanelContext& context, PanelPlace side, const PixelRect& area) {
  std::vector<const PanelRow*> rows;
  const Layout& layout = context.layout;
  for (const PanelRow& row : panel_list())
    if (row.place != PanelPlace::over && layout.side_of(row) == side && layout.is_shown(row)) rows.push_back(&row);
  const float gap = 3 * context.scale;
  const ImVec2 size{static_cast<float>(area.width()), static_cast<float>(area.height())};
  ImGui::SetNextWindowPos({static_cast<float>(area.x0), static_cast<float>(area.y0)});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {gap, gap});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(column_window(side), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar(3);
  draw_strip_of(context, side, rows, size, gap);
  ImGui::End();
}

}  // namespace ryosen
