// The menu of what was clicked with the right button.
#include <algorithm>
#include <utility>

#include "app/editor/camera/view_state.h"
#include "app/editor/commands/commands.h"
#include "app/editor/document/findings.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/operator_selection.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/asked_values.h"
#include "app/ui/menu.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/ops/all.h"

namespace ryosen {

namespace {

std::string help_of(const PanelContext& context, const OpInfo& op, const Offer& offer) {
  std::string help = context.text(op.help_en, op.help_ja);
  for (const Text& sentence : offer.why_not) help += "\n" + sentence.in(context.language());
  return help;
}

void operator_item(PanelContext& context, const OpInfo& op, const Offer& offer) {
  const std::string line = std::string(op.id) + " selected", chord = chord_of(context.preferences, line);
  if (ImGui::MenuItem(context.text(op.name_en, op.name_ja), chord.c_str(), false, offer.may_be)) context.run(line);
  tip(help_of(context, op, offer), ImGuiHoveredFlags_AllowWhenDisabled);
}

// Asks for its numbers and positions first.
void values_item(PanelContext& context, const OpInfo& op, const Offer& offer) {
  if (!takes_numbers(op)) return;
  const std::string line = "values " + std::string(op.id), chord = chord_of(context.preferences, line),
                    name = std::string(context.text(op.name_en, op.name_ja)) + "...";
  if (ImGui::MenuItem(name.c_str(), chord.c_str(), false, offer.may_be)) context.run(line);
  tip(help_of(context, op, offer), ImGuiHoveredFlags_AllowWhenDisabled);
}

// What unites several may do so in their middle too.
void middle_item(PanelContext& context, const OpInfo& op) {
  constexpr std::string_view middle[] = {"mid"};
  if (op.on_selection != OnSelection::into_last || !fits_selection(context.findings(), context.selecting, op, middle))
    return;
  const std::string line = std::string(op.id) + " selected mid", chord = chord_of(context.preferences, line);
  const std::string label =
      std::string(context.text(op.name_en, op.name_ja)) + context.text(" in the middle", "（中央）");
  if (ImGui::MenuItem(label.c_str(), chord.c_str())) context.run(line);
  tip(context.text(op.help_en, op.help_ja));
}

void operator_items(PanelContext& context, const OpGroupRow& group) {
  for (const OpInfo& op : all_ops()) {
    if (op.group != group.group || !fits_selection(context.findings(), context.selecting, op)) continue;
    const Offer offer = offer_on_selection(context.findings(), context.selecting, op);
    operator_item(context, op, offer);
    values_item(context, op, offer);
    middle_item(context, op);
  }
}

void group_menu(PanelContext& context, const OpGroupRow& group) {
  const auto fits = [&](const OpInfo& op) {
    return op.group == group.group && fits_selection(context.findings(), context.selecting, op);
  };
  if (std::none_of(all_ops().begin(), all_ops().end(), fits)) return;
  const bool is_open = begin_submenu(context.text(group.en, group.ja));
  tip(context.text(group.help_en, group.help_ja));
  if (!is_open) return;
  operator_items(context, group);
  ImGui::EndMenu();
}

// What may be selected from what is selected; with nothing, what may be selected at all.
void selector_menu(PanelContext& context) {
  if (!begin_submenu(context.text("Select", "選択"))) return;
  for (const Selector& row : selectors()) {
    if (row.value != Selector::Value::none && row.usual.empty()) continue;
    if (!row.needs && !row.needs_any && !context.selecting.selection.empty()) continue;
    if (!missing_for(row, context.selecting.selection).en.empty()) continue;
    const std::string line = select_line(row), chord = chord_of(context.preferences, line);
    if (ImGui::MenuItem(context.text(row.name_en, row.name_ja), chord.c_str())) context.run(line);
  }
  ImGui::EndMenu();
}

void gesture_items(PanelContext& context) {
  const auto item = [&](const char* en, const char* ja, const char* line) {
    if (ImGui::MenuItem(context.text(en, ja), chord_of(context.preferences, line).c_str())) context.run(line);
  };
  item("Move", "移動", "gesture move");
  item("Turn", "回転", "gesture turn");
  item("Scale", "拡大縮小", "gesture scale");
  const auto is_no_vertex = [](const Element& e) { return e.kind != Element::Kind::vertex; };
  if (std::any_of(context.selecting.selection.begin(), context.selecting.selection.end(), is_no_vertex))
    item("Extrude and move", "押し出して移動", "gesture extrude");
  const Elements& selection = context.selecting.selection;
  if (selection.size() == 1 &&
      (selection[0].kind == Element::Kind::edge || selection[0].kind == Element::Kind::halfedge))
    item("Split and move", "分けて移動", "gesture split");
  ImGui::Separator();
}

std::string title(PanelContext& context) {
  const std::vector<Element>& selection = context.selecting.selection;
  if (selection.empty()) return context.text("Nothing is selected", "選択なし");
  if (selection.size() == 1) return context.selecting.selected_names()[0];
  return grouped(static_cast<std::int64_t>(selection.size())) + context.text(" selected", " 個を選択中");
}

// Beside the pointer, or where there is no room above or below it: it is on no entry then.
void open_at_pointer(PanelContext& context) {
  ImGui::OpenPopup("##element");
  const ImVec2 all = ImGui::GetIO().DisplaySize, at = ImGui::GetIO().MousePos;
  const float wide = 22 * ImGui::GetFontSize(), border = ImGui::GetStyle().DisplaySafeAreaPadding.y, gap = 2;
  const bool goes_right = at.x + gap + wide <= all.x, goes_left = !goes_right && at.x - gap >= wide;
  if (goes_right || goes_left) {
    context.state.menus.room_px = all.y - 2 * border;
    ImGui::SetNextWindowPos({goes_right ? at.x + gap : at.x - gap, at.y}, ImGuiCond_Appearing,
                            {goes_right ? 0.f : 1.f, at.y / all.y});
    return;
  }
  const bool goes_up = at.y > 0.5f * all.y;
  context.state.menus.room_px = std::max((goes_up ? at.y : all.y - at.y) - border, 1.f);
  ImGui::SetNextWindowPos(at, ImGuiCond_Appearing, {at.x / all.x, goes_up ? 1.f : 0.f});
}

}  // namespace

void draw_element_menu(PanelContext& context) {
  if (std::exchange(context.state.menus.opens, false)) open_at_pointer(context);
  // Where that is too little it is scrolled.
  ImGui::SetNextWindowSizeConstraints({0, 0}, {ImGui::GetIO().DisplaySize.x, context.state.menus.room_px});
  if (!ImGui::BeginPopup("##element")) return;
  // In one line: wrapped, it would be as high as it is long in the frame that finds out how large the menu is.
  ImGui::TextColored(context.colours().dim, "%s", title(context).c_str());
  ImGui::Separator();
  if (!context.selecting.selection.empty()) gesture_items(context);
  for (const OpGroupRow& group : op_groups())
    if (!group.is_apart) operator_items(context, group);
  for (const OpGroupRow& group : op_groups())
    if (group.is_apart) group_menu(context, group);
  ImGui::Separator();
  selector_menu(context);
  const std::string frame = context.selecting.selection.empty() ? "frame all" : "frame selected";
  const UiText name = context.selecting.selection.empty() ? UiText::frame_all : UiText::frame_selected;
  if (ImGui::MenuItem(context.text(name), chord_of(context.preferences, frame).c_str())) context.run(frame);
  const auto hiding = [&](UiText name_of, const char* line) {
    if (ImGui::MenuItem(context.text(name_of), chord_of(context.preferences, line).c_str())) context.run(line);
  };
  if (!context.selecting.selection.empty()) {
    hiding(UiText::hide_selected, "hide selected");
    hiding(UiText::isolate_selected, "isolate selected");
  }
  ImGui::EndPopup();
}

void draw_band(PanelContext& context) {
  if (!context.view.band) return;
  const Band& band = *context.view.band;
  std::vector<ImVec2> corners;
  for (const glm::dvec2& p : band.path) corners.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
  if (band.action == DragAction::box)
    corners = {
        corners.front(), {corners.back().x, corners.front().y}, corners.back(), {corners.front().x, corners.back().y}};
  const ImVec2 low{static_cast<float>(context.view.origin.x), static_cast<float>(context.view.origin.y)};
  ImDrawList* const draw = ImGui::GetBackgroundDrawList();
  draw->PushClipRect(
      low, {low.x + static_cast<float>(context.view.size.width), low.y + static_cast<float>(context.view.size.height)});
  const ImVec4 colour = to_imgui(style(Role::selected, context.theme).colour);
  if (band.action == DragAction::box)
    draw->AddRectFilled(corners[0], corners[2], ImGui::GetColorU32({colour.x, colour.y, colour.z, 0.12f}));
  draw->AddPolyline(corners.data(), static_cast<int>(corners.size()), ImGui::GetColorU32(colour), ImDrawFlags_Closed,
                    1.5f * context.scale);
  draw->PopClipRect();
}

}  // namespace ryosen
