// What each button of the mouse does now, and what the last command said.
#include <algorithm>
#include <cmath>

#include "app/editor/camera/view_state.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/asking.h"
#include "app/editor/session/pointing.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/gesturing.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/base/count_text.h"

namespace ryosen {

namespace {

struct Hint {
  std::string button, does;
};

// What it does now, how it ends and how it is taken back, which always have room; then what else may be pressed.
std::vector<Hint> hints_of_gesture(const PanelContext& context, const TransformGesture& gesture) {
  std::string told = gesture.told().in(context.language());
  if (const std::size_t spoilt = context.gesturing.spoilt().size(); spoilt > 0)
    told += count_text(spoilt, " (one face turns over or flattens)", " (# faces turn over or flatten)",
                       "（裏返る面・つぶれる面 #）")
                .in(context.language());
  std::vector<Hint> hints{{"", told},
                          {context.text("Enter, click", "Enter・クリック"), context.text("done", "確定")},
                          {"Esc", context.text("give up", "中止")},
                          {"X Y Z N", context.text("axis", "軸")},
                          {"0-9", context.text("number", "数値")}};
  if (gesture.takes_falloff())
    hints.push_back({"O", gesture.has_falloff() ? context.text("falloff, wheel widens", "減衰（ホイールで広げる）")
                                                : context.text("falloff", "減衰")});
  hints.push_back({"Ctrl", context.text("snap", "吸着")});
  return hints;
}

// "2 vertices, 1 face"
Text counted(const Selection& selection) {
  Text told;
  constexpr struct {
    Element::Kind kind;
    const char *one_en, *many_en, *many_ja;
  } words[] = {{Element::Kind::vertex, "1 vertex", "# vertices", "頂点 #"},
               {Element::Kind::edge, "1 edge", "# edges", "稜線 #"},
               {Element::Kind::halfedge, "1 halfedge", "# halfedges", "半稜線 #"},
               {Element::Kind::face, "1 face", "# faces", "面 #"}};
  for (const auto& [kind, one_en, many_en, many_ja] : words) {
    const std::size_t n = selection.count(kind);
    if (n == 0) continue;
    if (!told.en.empty()) told += Text{", ", "、"};
    told += count_text(n, one_en, many_en, many_ja);
  }
  return told;
}

std::vector<Hint> hints_of(const PanelContext& context) {
  if (const TransformGesture* const gesture = context.gesturing.transform()) return hints_of_gesture(context, *gesture);
  if (context.view.band)
    return {{context.text("Release", "離す"), context.text("select what is inside", "囲んだものを選択")},
            {"Esc", context.text("give up", "中止")}};
  const auto drag = [&](MouseButton button) -> std::string {
    const auto armed = context.view.armed_drag;
    if (armed && button == MouseButton::left)
      return *armed == DragAction::box ? context.text("draw a box, Esc gives up", "ボックスを描く（Esc で中止）")
                                       : context.text("draw a lasso, Esc gives up", "投げ縄を描く（Esc で中止）");
    return help_of(drag_action_of(input_presets()[context.preferences.input_preset], button, {}))
        .in(context.language());
  };
  if (!context.selecting.asked_line.empty())
    return {{"", asked_text(context.selecting.asked_line).in(context.language())},
            {"Esc", context.text("give up", "中止")}};
  if (const HandleRow* const handle = context.pointing.pointed_handle())
    return {{context.text("Drag", "ドラッグ"), context.text(handle->does_en, handle->does_ja)},
            {"Ctrl", context.text("snap", "吸着")},
            {"Esc", context.text("give up", "中止")}};
  if (const AxisEnd* const end = context.pointing.pointed_axis_end())
    return {{context.text("Click", "クリック"),
             context.text("look from ", "") + std::string(end->name) + context.text("", " 側から見る")},
            {context.text("Drag", "ドラッグ"), drag(MouseButton::left)}};
  const OpInfo* const op = find_op(context.selecting.tool);
  std::vector<Hint> hints{{context.text("Click", "クリック"),
                           op ? context.text(op->name_en, op->name_ja) : context.text(UiText::does_pick)},
                          {context.text("Drag", "ドラッグ"), drag(MouseButton::left)},
                          {context.text("Right drag", "右ドラッグ"), drag(MouseButton::right)},
                          {context.text(UiText::wheel), help_of(DragAction::zoom).in(context.language())}};
  // The middle button where it alone does something, as to orbit in some presets.
  const std::string by_middle = drag(MouseButton::middle);
  const auto does = [&](const Hint& hint) { return hint.does == by_middle; };
  if (std::none_of(hints.begin(), hints.end(), does))
    hints.insert(hints.begin() + 2, {context.text("Middle drag", "中ドラッグ"), by_middle});
  if (const auto asked = context.selecting.asking_verdicts())
    hints.insert(hints.begin(), {context.text("Verdicts", "判定"), std::to_string(std::lround(100 * *asked)) + " %"});
  if (!context.selecting.selection.empty())
    hints.insert(hints.begin(),
                 {context.text("Selected", "選択中"), counted(context.selecting.selection).in(context.language())});
  return hints;
}

float word_gap() { return 0.4f * ImGui::GetFontSize(); }
float hint_gap() { return 1.4f * ImGui::GetFontSize(); }
float width_of(const Hint& hint) {
  return ImGui::CalcTextSize(hint.button.c_str()).x + word_gap() + ImGui::CalcTextSize(hint.does.c_str()).x;
}

// As many as have room.
void draw_hints(PanelContext& context, const std::vector<Hint>& hints, float room) {
  for (const Hint& hint : hints) {
    room -= width_of(hint);
    if (room < 0) return;
    ImGui::TextColored(context.colours().dim, "%s", hint.button.c_str());
    ImGui::SameLine(0, word_gap());
    ImGui::TextUnformatted(hint.does.c_str());
    ImGui::SameLine(0, hint_gap());
    room -= hint_gap();
  }
}

// At the right, with short numbers; where it does not fit in fewer words, or with an ellipsis. What is not shown as it
// was said is whole in a tooltip.
void draw_said(PanelContext& context, const std::string& said, float end, float room) {
  const ImVec4 colour = context.state.last.kind == Outcome::Kind::done      ? context.colours().legal
                        : context.state.last.kind == Outcome::Kind::refused ? context.colours().refused
                                                                            : context.colours().warning;
  std::string told = with_short_numbers(said);
  for (const Text& shorter : context.state.last.shorter) {
    if (ImGui::CalcTextSize(told.c_str()).x <= room) break;
    told = with_short_numbers(shorter.in(context.language()));
  }
  const std::string shown = fitted(told, room);
  ImGui::SetCursorPosX(end - std::min(room, ImGui::CalcTextSize(shown.c_str()).x));
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopStyleColor();
  if (shown != said) tip(said);
}

void draw_line(PanelContext& context, float width, float padding) {
  std::vector<Hint> hints = hints_of(context);
  const std::string& said = context.state.last.sentence.in(context.language());
  const float all = width - 2 * padding;
  if (context.gesturing.is_active()) {
    const float ends = width_of(hints[1]) + width_of(hints[2]) + 2 * hint_gap() + word_gap();
    hints[0].does = fitted(hints[0].does, all - ends);
  }
  const bool asks = !context.selecting.asked_line.empty();
  // What is asked stands before what was said, but for why it is asked again.
  const bool is_refused = context.state.last.kind != Outcome::Kind::done && said != hints[0].does;
  if (said.empty() || context.gesturing.is_active() || (asks && !is_refused)) return draw_hints(context, hints, all);
  float hinted = 0;
  for (const Hint& hint : hints) hinted += width_of(hint) + hint_gap();
  // What was said comes before the hints.
  const float least = (asks ? 0.5f : 0.75f) * all, wanted = ImGui::CalcTextSize(with_short_numbers(said).c_str()).x;
  const float room = std::min(wanted, std::max(all - hinted, least));
  const ImVec2 begin = ImGui::GetCursorPos();
  draw_hints(context, hints, all - room - hint_gap());
  ImGui::SetCursorPos(begin);
  draw_said(context, said, width - padding, room);
}

}  // namespace

void draw_status(PanelContext& context) {
  const float height = ImGui::GetFrameHeight(), padding = 12 * context.scale;
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, all.y - height});
  ImGui::SetNextWindowSize({all.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, (height - ImGui::GetFontSize()) / 2});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
  ImGui::Begin("##status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing);
  draw_line(context, all.x, padding);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace ryosen
