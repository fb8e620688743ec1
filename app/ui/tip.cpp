// Tooltips, where they cover nothing that is to be clicked next.
#include <imgui_internal.h>  // which window an item belongs to

#include <algorithm>

#include "app/ui/side_columns.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// Where what is told of an item goes where there is no room beside its panel: a row above it, so that what follows may
// be clicked next, else a row below it. So that both its neighbours are seen.
ImVec2 place_over_panel(ImVec2 first, ImVec2 last, ImVec2 size) {
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float row = ImGui::GetFrameHeightWithSpacing(), above = first.y - row - size.y, below = last.y + row;
  const bool goes_above = above >= 0 || first.y > all.y - last.y;
  return {std::max(0.f, std::min(first.x, all.x - size.x)), goes_above ? std::max(above, 0.f) : below};
}

// Where the keyboard is at an item, the next ones are those around it: as far away from it as can be.
ImVec2 place_away(ImVec2 first, ImVec2 last, ImVec2 size) {
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const bool goes_below = all.y - last.y >= first.y;
  return {std::max(0.f, std::min(first.x, all.x - size.x)), goes_below ? all.y - size.y : 0};
}

// The room beside a panel, as far as the other column.
struct Beside {
  float begin, end;
};
Beside beside(const ImGuiWindow& panel, bool goes_right) {
  const float all = ImGui::GetIO().DisplaySize.x;
  Beside room = goes_right ? Beside{panel.Pos.x + panel.Size.x, all} : Beside{0, panel.Pos.x};
  const ImGuiWindow* const other =
      ImGui::FindWindowByName(column_window(goes_right ? PanelPlace::right : PanelPlace::left));
  const bool is_over_all = (panel.Flags & ImGuiWindowFlags_Popup) != 0;
  if (!other || other == &panel || !other->WasActive || is_over_all) return room;
  if (goes_right)
    room.end = std::max(room.begin, other->Pos.x);
  else
    room.begin = std::min(room.end, other->Pos.x + other->Size.x);
  return room;
}

}  // namespace

void tip(std::string_view text, ImGuiHoveredFlags hovered) {
  if (ImGui::IsItemHovered(hovered)) tip_shown(text);
}

void tip_shown(std::string_view text) {
  const ImGuiWindow& panel = *ImGui::GetCurrentWindow()->RootWindow;
  const ImVec2 all = ImGui::GetIO().DisplaySize, first = ImGui::GetItemRectMin();
  ImVec2 last = ImGui::GetItemRectMax();
  last.y = std::min(last.y, all.y);  // of what is scrolled, a part may lie below the window
  const float em = ImGui::GetFontSize(), gap = em / 2;
  const bool goes_right = all.x - panel.Pos.x - panel.Size.x >= panel.Pos.x;
  const Beside free = beside(panel, goes_right);
  const float room = free.end - free.begin - 2 * gap - 2 * ImGui::GetStyle().WindowPadding.x;
  const bool is_beside = room > 8 * em;
  const float width = is_beside ? std::min(22 * em, room) : 22 * em;
  if (!is_beside) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const ImVec2 inside = wrapped_size(text, width), padding = ImGui::GetStyle().WindowPadding;
    ImGui::PopStyleVar();
    const ImVec2 size{inside.x + 2 * padding.x, inside.y + 2 * padding.y};
    const bool is_of_keyboard = GImGui->NavDisableMouseHover;
    ImGui::SetNextWindowPos(is_of_keyboard ? place_away(first, last, size) : place_over_panel(first, last, size));
  }
  if (is_beside) {
    const bool hangs = first.y < 0.6f * all.y;
    ImGui::SetNextWindowPos({goes_right ? free.begin + gap : free.end - gap, hangs ? first.y : last.y}, 0,
                            {goes_right ? 0.f : 1.f, hangs ? 0.f : 1.f});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // also of what is faded
  ImGui::BeginTooltip();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  wrapped_text(text, width);
  ImGui::PopStyleVar(2);
  ImGui::EndTooltip();
}

}  // namespace ryosen
