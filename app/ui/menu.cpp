// The bar of menus, with the name of what is shown and the switch of the language.
#include <imgui_internal.h>  // moves of the keyboard that no menu has taken

#include <algorithm>
#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/preferences/menu_bar.h"
#include "app/editor/shown/shown.h"
#include "app/ui/menu_entries.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// With its first entry chosen. Where the pointer lies counts again once it moves.
void open_for_keys(const char* title) {
  ImGui::OpenPopup(title);
  GImGui->NavDisableHighlight = false;
  GImGui->NavDisableMouseHover = true;
}

// An arrow to the side that no menu below has taken leads to the next menu of the bar.
void go_sideways(PanelContext& context, const MenuRow& open) {
  if (!ImGui::NavMoveRequestButNoResultYet()) return;
  const ImGuiDir direction = GImGui->NavMoveDir;
  if (direction != ImGuiDir_Left && direction != ImGuiDir_Right) return;
  const std::size_t n = std::size(menu_bar), at = static_cast<std::size_t>(&open - menu_bar);
  context.layout.asked_menu = &menu_bar[(at + (direction == ImGuiDir_Left ? n - 1 : 1)) % n];
  context.state.unsettle();
  ImGui::NavMoveRequestCancel();
}

// The name of what is shown: in the middle of the bar, or of what the menus leave of it up to here. What lies beneath
// is told where there is room for it.
void draw_name(PanelContext& context, float end) {
  std::string name = shown_name(context.session);
  const std::string whole = name;
  const float gap = ImGui::GetFontSize() / 2, begin = ImGui::GetCursorPosX() + gap, room = end - gap - begin;
  if (room < 2 * ImGui::GetFontSize()) return;
  if (ImGui::CalcTextSize(name.c_str()).x > room) name = shown_name(context.session, false);
  const float width = std::min(ImGui::CalcTextSize(name.c_str()).x, room);
  ImGui::SetCursorPosX(std::clamp((ImGui::GetIO().DisplaySize.x - width) / 2, begin, begin + room - width));
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
  const std::string shown = fitted_at_word(name, room);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopStyleColor();
  if (shown != whole) tip(whole);
}

// What there is room for beside the menus: they stand closer, and then the switch of the language, which the
// preferences have too, gives way before the name does.
struct BarRoom {
  float spacing;
  bool has_language;
};

BarRoom room_in_bar(const PanelContext& context, float language_px) {
  const float em = ImGui::GetFontSize(), all = ImGui::GetIO().DisplaySize.x;
  const float name = std::min(ImGui::CalcTextSize(shown_name(context.session).c_str()).x, 4 * em) + em;
  float titles = 0;
  for (const MenuRow& row : menu_bar) titles += ImGui::CalcTextSize(context.text(row.title_en, row.title_ja)).x;
  const float wide = ImGui::GetStyle().ItemSpacing.x, close = 0.5f * wide;
  const auto fits = [&](float spacing, float language) {
    return titles + 2 * spacing * static_cast<float>(std::size(menu_bar)) + 2 * wide + name + language <= all;
  };
  if (fits(wide, language_px)) return {wide, true};
  return {close, fits(close, language_px)};
}

// Between the entries of a menu: less where the window is hardly as high as the longest of those that are not scrolled.
float row_gap(float window_px) {
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  return window_px < 27 * ImGui::GetTextLineHeightWithSpacing() ? std::floor(0.75f * gap) : gap;
}

}  // namespace

void draw_menu(PanelContext& context) {
  if (!ImGui::BeginMainMenuBar()) return;
  // Before any is drawn: all have one window, which is to show one of them in a frame.
  const auto title_of = [&](const MenuRow& row) { return context.text(row.title_en, row.title_ja); };
  const MenuRow* const asked = std::exchange(context.layout.asked_menu, nullptr);
  if (asked && context.layout.open_panel.empty()) open_for_keys(title_of(*asked));
  const char* const other = context.text(UiText::language_other);
  const float width = ImGui::CalcTextSize(other).x + 3 * ImGui::GetStyle().ItemSpacing.x;
  const BarRoom room = room_in_bar(context, width);
  const MenuRow* open = nullptr;
  for (std::size_t i = 0; i < std::size(menu_bar); ++i) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {room.spacing, ImGui::GetStyle().ItemSpacing.y});
    // Below the bar, where it is scrolled if it is long.
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float border = ImGui::GetStyle().DisplaySafeAreaPadding.y;
    ImGui::SetNextWindowSizeConstraints({0, 0}, {all.x, all.y - ImGui::GetWindowHeight() - border});
    const bool is_open = ImGui::BeginMenu(title_of(menu_bar[i]));
    ImGui::PopStyleVar();
    if (!is_open) continue;
    open = &menu_bar[i];
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, row_gap(all.y)});
    draw_entries(context, menu_bar[i]);
    ImGui::EndMenu();
    ImGui::PopStyleVar();
  }
  if (open) go_sideways(context, *open);
  const float end = ImGui::GetIO().DisplaySize.x - (room.has_language ? width : 0);
  draw_name(context, end);
  if (room.has_language) {
    ImGui::SameLine(end);
    if (ImGui::MenuItem(other)) context.run(context.language() == Language::english ? "language ja" : "language en");
  }
  ImGui::EndMainMenuBar();
}

}  // namespace ryosen
