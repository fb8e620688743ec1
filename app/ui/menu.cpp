// The bar of menus with what stands in them, the name of what is shown and the switch of the language.
#include "app/ui/menu.h"

#include <imgui_internal.h>  // moves of the keyboard that no menu has taken, and where menus lie

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/findings.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/preferences/view_switches.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/levels.h"
#include "app/editor/shown/shown.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/document/document.h"
#include "ryosen/scene/view/named_views.h"
// clang-format off
#include <imgui_stdlib.h>  // needs imgui.h before it
// clang-format on

namespace ryosen {

namespace {

void item(PanelContext& context, const char* name, const std::string& line, bool enabled = true, bool ticked = false) {
  const std::string chord = chord_of(context.preferences, line);
  if (ImGui::MenuItem(name, chord.empty() ? nullptr : chord.c_str(), ticked, enabled)) context.run(line);
}
void item(PanelContext& context, UiText name, const std::string& line, bool enabled = true, bool ticked = false) {
  item(context, context.text(name), line, enabled, ticked);
}

// The panels of a menu: what opens one over the view ends in dots; those of the columns are ticked where they are
// shown, and stand together in the menu of the view.
void panel_items(PanelContext& context, PanelMenu menu) {
  for (const PanelRow& row : panel_list()) {
    const bool is_over = row.place == PanelPlace::over, is_ticked = !is_over && context.layout.is_shown(row);
    if (row.menu != menu && (menu != PanelMenu::view || is_over)) continue;
    const std::string name = std::string(context.title(row)) + (is_over ? "..." : "");
    const char* const switched = is_over ? "" : is_ticked ? " off" : " on";
    item(context, name.c_str(), "panel " + std::string(row.id) + switched, true, is_ticked);
  }
}

void draw_recent_menu(PanelContext& context) {
  if (!begin_submenu(context.text("Open recent", "最近のファイル"), !context.preferences.recent.empty())) return;
  for (const std::string& file : context.preferences.recent) item(context, file.c_str(), "open " + file_argument(file));
  ImGui::EndMenu();
}

void draw_file_menu(PanelContext& context) {
  item(context, context.text("Start page", "開始画面"), "start");
  item(context, context.text("New", "新規"), "new");
  panel_items(context, PanelMenu::file_read);
  draw_recent_menu(context);
  const auto compare = find_command_row("compare");
  if (context.findings().against && compare)
    for (const NamedCall& call : compare->named) item(context, context.text(call.en, call.ja), std::string(call.line));
  ImGui::Separator();
  item(context, UiText::save, "save", !context.document().path().empty());
  panel_items(context, PanelMenu::file_write);
  ImGui::Separator();
  item(context, UiText::quit, "quit");
}

void algorithm_item(PanelContext& context, const AlgorithmRow& row) {
  const std::string name = context.text(row.name_en, row.name_ja);
  if (row.parameters.empty())
    item(context, name.c_str(), called(row));
  else
    item(context, (name + "...").c_str(), "values " + std::string(row.id));
}

// What keys do with the selection, and by hand, whatever they are bound to now.
void key_items(PanelContext& context, KeyMenu menu) {
  for (const KeyRow& row : key_table())
    if (row.menu == menu)
      item(context, context.text(row.menu_en, row.menu_ja), row.command,
           menu != KeyMenu::edit || !context.selecting.selection.empty());
}

void draw_edit_menu(PanelContext& context) {
  const Document& document = context.document();
  item(context, UiText::undo, "undo",
       document.position() > 0 || context.shown.response(Effect::steps) == Response::instead);
  item(context, UiText::redo, "redo", document.position() < document.history().size());
  ImGui::Separator();
  for (const OpInfo& op : all_ops()) {
    if (op.key == '\0') continue;  // operators without a key are only in the tools panel
    item(context, context.text(op.name_en, op.name_ja), line_of_key(op), true, context.selecting.tool == op.id);
  }
  ImGui::Separator();
  key_items(context, KeyMenu::edit);
  item(context, context.text("Duplicate in place", "その場に複製"), "duplicate elements=selected",
       !context.selecting.selection.empty());
  item(context, context.text("Mirror...", "鏡像..."), "values mirror");
  ImGui::Separator();
  if (begin_submenu(context.text("Algorithms", "アルゴリズム"))) {
    for (const AlgorithmRow& row : algorithm_table())
      if (!row.is_primitive) algorithm_item(context, row);
    ImGui::EndMenu();
  }
  panel_items(context, PanelMenu::edit);
}

// All elements that have a problem of a kind.
void draw_select_problems(PanelContext& context) {
  if (!begin_submenu(context.text("What is broken", "問題のある要素"))) return;
  const HighlightSets& sets = context.findings().highlights();
  for (const ProblemRow& row : problem_table())
    if (row.is_local() || row.is_on_request())
      item(context, context.text(row.name_en, row.name_ja), select_line(row), sets.count(row.kind) > 0);
  ImGui::EndMenu();
}

// A menu with a field for its value, which has the keyboard at once.
void draw_selector_field(PanelContext& context, const Selector& row) {
  const char* const name =
      row.menu_en.empty() ? context.text(row.name_en, row.name_ja) : context.text(row.menu_en, row.menu_ja);
  if (!begin_submenu(name, missing_for(row, context.selecting.selection).en.empty())) return;
  dim_text(context, context.text(row.value_en, row.value_ja));
  std::string& value = context.state.selector_values.try_emplace(row.id, row.usual).first->second;
  if (ImGui::IsWindowAppearing() || is_left_alone("##value")) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(120 * context.scale);
  const bool entered =
      ImGui::InputText("##value", &value, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::SameLine();
  ImGui::BeginDisabled(!parse_value(row, value));
  const bool pressed = ImGui::Button(context.text("Select", "選択"));
  ImGui::EndDisabled();
  if ((entered || pressed) && parse_value(row, value)) {
    context.run("select " + std::string(row.id) + " " + value);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndMenu();
}

// What needs a value that has no usual one and no field is only a command.
void draw_select_menu(PanelContext& context) {
  for (const Selector& row : selectors()) {
    if (!is_in_menu(row)) continue;
    if (!row.value_en.empty()) {
      draw_selector_field(context, row);
      continue;
    }
    item(context, context.text(row.name_en, row.name_ja), select_line(row),
         missing_for(row, context.selecting.selection).en.empty());
  }
  draw_select_problems(context);
  ImGui::Separator();
  key_items(context, KeyMenu::select);
  ImGui::Separator();
  item(context, UiText::hide_selected, "hide selected", !context.selecting.selection.empty());
  item(context, UiText::isolate_selected, "isolate selected", !context.selecting.selection.empty());
  item(context, UiText::unhide, "unhide", !context.findings().hidden().empty());
  ImGui::Separator();
  if (ImGui::MenuItem(context.text(UiText::keep_selection), "", false, !context.selecting.selection.empty()))
    context.begin_command("keep ");
  for (const auto& [name, elements] : context.selecting.memory.kept)
    if (ImGui::MenuItem(name.c_str(), std::to_string(elements.size()).c_str()))
      context.run("select kept " + file_argument(name));
}

// Of two values that a key goes between the second one, ticked where it is on; else one entry for each.
bool is_one_entry(const ViewSwitch& row) { return row.toggles() && row.values.size() == 2; }
bool is_one_line(const ViewSwitch& row) { return is_one_entry(row) || !row.menu_en.empty(); }
void draw_switch(PanelContext& context, const ViewSwitch& row) {
  const std::size_t now = row.value(context.session);
  const bool is_one = is_one_entry(row);
  for (std::size_t i = is_one ? 1 : 0; i < row.values.size(); ++i) {
    const SwitchValue& value = row.values[i];
    item(context, context.text(value.name_en, value.name_ja),
         is_one ? toggle_line(row) : std::string(row.id) + " " + std::string(value.id), true, i == now);
  }
}
// With lines between groups, but not between single entries.
void draw_switches(PanelContext& context) {
  const ViewSwitch* before = nullptr;
  for (const ViewSwitch& row : view_switches()) {
    if (before && !(is_one_line(*before) && is_one_line(row))) ImGui::Separator();
    if (row.menu_en.empty()) {
      draw_switch(context, row);
    } else if (begin_submenu(context.text(row.menu_en, row.menu_ja))) {
      draw_switch(context, row);
      ImGui::EndMenu();
    }
    before = &row;
  }
  ImGui::Separator();
}

void draw_view_menu(PanelContext& context) {
  item(context, UiText::frame_all, "frame all");
  item(context, UiText::frame_selected, "frame selected", !context.selecting.selection.empty());
  ImGui::Separator();
  if (begin_submenu(context.text("Look from", "視点"))) {
    for (const NamedView& view : named_views())
      item(context, context.text(view.name_en, view.name_ja), "view " + std::string(view.id));
    ImGui::EndMenu();
  }
  ImGui::Separator();
  draw_switches(context);
  if (begin_submenu(context.text("Panels", "パネル"))) {
    panel_items(context, PanelMenu::view);
    ImGui::EndMenu();
  }
}

void draw_add_menu(PanelContext& context) {
  for (const AlgorithmRow& row : algorithm_table())
    if (row.is_primitive) algorithm_item(context, row);
}

// Panels, then scripts of the source texts. They are in no submenu: a narrow window has no room for such long names
// beside this one.
void draw_help_menu(PanelContext& context) {
  panel_items(context, PanelMenu::help);
  for (const OfferedCalls& offered : textbook_calls()) {
    ImGui::Separator();
    ImGui::TextColored(context.colours().dim, "%s", offered.title.in(context.language()).c_str());
    for (const auto& [name, line] : offered.calls) item(context, name.in(context.language()).c_str(), line);
  }
}

// In the order of menu_bar.
constexpr std::array<void (*)(PanelContext&), std::size(menu_bar)> menus{
    draw_file_menu, draw_edit_menu, draw_select_menu, draw_view_menu, draw_add_menu, draw_help_menu};

// The entries of a row of menu_bar, in the menu that is open.
void draw_entries(PanelContext& context, const MenuRow& menu) {
  menus[static_cast<std::size_t>(&menu - menu_bar)](context);
}

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

bool begin_submenu(const char* name, bool is_enabled) {
  char window[16];
  std::snprintf(window, sizeof window, "##Menu_%02d", GImGui->BeginMenuCount);  // as ImGui calls it
  const ImGuiWindow& around = *ImGui::GetCurrentWindow();
  const ImGuiWindow* const before = ImGui::FindWindowByName(window);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float room = ImGui::GetIO().DisplaySize.x - style.DisplaySafeAreaPadding.x - around.Pos.x - around.Size.x;
  const float missing = before ? before->Size.x - room : 0, most = 0.6f * around.Size.x;
  // It overlaps the menu around by this gap.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing,
                      {std::clamp(std::ceil(missing), style.ItemInnerSpacing.x, most), style.ItemInnerSpacing.y});
  const bool is_open = ImGui::BeginMenu(name, is_enabled);
  ImGui::PopStyleVar();
  return is_open;
}

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
