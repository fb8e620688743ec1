#include <algorithm>
#include <cmath>

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

// The most that one of these heights may be so that together, with gaps between them, they fit into a room.
float most_of_each(const std::vector<float>& heights, float room, float gap) {
  std::vector<float> by_size = heights;
  std::sort(by_size.begin(), by_size.end());
  float left = room - gap;
  for (std::size_t i = 0; i < by_size.size(); ++i) {
    const float share = left / static_cast<float>(by_size.size() - i) - gap;
    if (by_size[i] > share) return share;
    left -= by_size[i] + gap;
  }
  return room;
}

// A click opens the panel, another closes it.
void draw_tab(PanelContext& context, PanelPlace side, const PanelRow& row, ImVec2 size, float letters) {
  const bool is_open = context.session.layout.flyout == row.id;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(row.id.data(), row.id.data() + row.id.size());
  if (ImGui::InvisibleButton("tab", size))
    context.run(is_open ? "panel none" : "panel " + std::string(row.id) + " flyout");
  const ImGuiCol fill = is_open                  ? ImGuiCol_FrameBgActive
                        : ImGui::IsItemHovered() ? ImGuiCol_HeaderHovered
                                                 : ImGuiCol_Header;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(fill), ImGui::GetStyle().FrameRounding);
  const bool is_left = side == PanelPlace::left;
  if (is_open) {
    const float mark = 3 * context.scale, x = is_left ? at.x + size.x - mark : at.x;
    list.AddRectFilled({x, at.y + 2}, {x + mark, at.y + size.y - 2}, ImGui::GetColorU32(context.colours().accent), 2);
  }
  turned_text({at.x + size.x / 2, at.y + size.y / 2}, fitted(context.short_title(row), letters),
              ImGui::GetColorU32(ImGuiCol_Text), is_left);
  if (!is_open) tip(context.title(row));
  ImGui::PopID();
}

}  // namespace

void draw_tabs(PanelContext& context, PanelPlace side, const PixelRect& area, int lanes) {
  std::vector<const PanelRow*> rows;
  const Layout& layout = context.session.layout;
  for (const PanelRow& row : panel_list())
    if (row.place != PanelPlace::over && layout.side_of(row) == side && layout.is_shown(row)) rows.push_back(&row);
  const float gap = 3 * context.scale, ends = 9 * context.scale;
  const std::size_t in_lane = (rows.size() + static_cast<std::size_t>(lanes) - 1) / static_cast<std::size_t>(lanes);
  const ImVec2 size{static_cast<float>(area.width()), static_cast<float>(area.height())};
  const float width = (size.x - gap) / static_cast<float>(lanes) - gap;
  ImGui::SetNextWindowPos({static_cast<float>(area.x0), static_cast<float>(area.y0)});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {gap, gap});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(side == PanelPlace::left ? "##left" : "##right", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing);
  for (std::size_t first = 0; first < rows.size(); first += in_lane) {
    std::vector<float> heights;
    for (std::size_t i = first; i < std::min(first + in_lane, rows.size()); ++i)
      heights.push_back(ImGui::CalcTextSize(context.short_title(*rows[i])).x + 2 * ends);
    const float most = most_of_each(heights, size.y, gap);
    float y = gap;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const float height = std::max(std::floor(std::min(heights[i], most)), 1.f);
      ImGui::SetCursorPos({gap + static_cast<float>(first / in_lane) * (width + gap), y});
      draw_tab(context, side, *rows[first + i], {width, height}, height - ends);
      y += height + gap;
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(4);
}

}  // namespace ryosen
