#include <array>
#include <cmath>

#include "app/editor/commands/commands.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/selecting.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/ops/all.h"

namespace ryosen {

namespace {

// What a press on an operator's row does: toggles the tool, applies the operator, to the selection where it takes one,
// or opens the command line for its arguments.
enum class Press { takes_tool, acts, asks };

Press press_of(const Selecting& selecting, const OpInfo& op) {
  if (is_tool(op)) return Press::takes_tool;
  const bool has_all =
      op.line.all_lists().empty() || (op.target == OpTargetKind::selection && !selecting.selection.empty());
  return has_all ? Press::acts : Press::asks;
}

// The mark of each at the right end of a row, in a square: a pointer, a filled triangle, three dots.
void mark_tool(ImDrawList& list, ImVec2 at, float size, ImU32 colour) {
  const auto place = [&](float x, float y) { return ImVec2(at.x + x * size, at.y + y * size); };
  list.AddTriangleFilled(place(0.25f, 0.1f), place(0.25f, 0.75f), place(0.72f, 0.58f), colour);
  list.AddLine(place(0.42f, 0.55f), place(0.6f, 0.92f), colour, std::max(size * 0.13f, 1.f));
}
void mark_act(ImDrawList& list, ImVec2 at, float size, ImU32 colour) {
  list.AddTriangleFilled({at.x + 0.2f * size, at.y + 0.15f * size}, {at.x + 0.2f * size, at.y + 0.85f * size},
                         {at.x + 0.85f * size, at.y + 0.5f * size}, colour);
}
void mark_question(ImDrawList& list, ImVec2 at, float size, ImU32 colour) {
  for (const float x : {0.18f, 0.5f, 0.82f})
    list.AddCircleFilled({at.x + x * size, at.y + 0.65f * size}, 0.1f * size, colour);
}

struct PressRow {
  Press press;
  void (*mark)(ImDrawList& list, ImVec2 at, float size, ImU32 colour);
  UiText help;
};
constexpr PressRow presses[] = {
    {Press::takes_tool, mark_tool, UiText::press_takes_tool},
    {Press::acts, mark_act, UiText::press_acts},
    {Press::asks, mark_question, UiText::press_asks},
};
static_assert(rows_are_in_order(presses, &PressRow::press));

void press(PanelContext& context, const OpInfo& op) {
  const std::string id(op.id);
  const Press does = press_of(context.selecting, op);
  if (does == Press::takes_tool) context.run(context.selecting.tool == id ? "tool none" : "tool " + id);
  if (does == Press::acts) context.run(op.line.all_lists().empty() ? id : id + " selected");
  if (does == Press::asks) context.begin_command(id + " ");
}

// A row that ends with the mark of what a press does.
bool marked_row(PanelContext& context, const char* name, const char* key, bool is_active, const PressRow& kind) {
  const float size = 11 * context.scale, free = size + 4 * context.scale;
  const bool is_pressed = row(context, name, key, is_active, free);
  const ImVec2 first = ImGui::GetItemRectMin(), last = ImGui::GetItemRectMax();
  const ImVec2 at{std::floor(last.x - size - 9 * context.scale), std::floor((first.y + last.y - size) / 2)};
  const ImVec4& colour = kind.press == Press::acts ? context.colours().accent : context.colours().dim;
  kind.mark(*ImGui::GetWindowDrawList(), at, size, ImGui::GetColorU32(colour));
  return is_pressed;
}

void draw_operator(PanelContext& context, const OpInfo& op, std::span<const KeyRow> keys) {
  ImGui::PushID(op.id.data());
  const std::string key = chord_of(keys, line_of_key(op));
  const PressRow& kind = presses[static_cast<std::size_t>(press_of(context.selecting, op))];
  if (marked_row(context, context.text(op.name_en, op.name_ja), key.c_str(), context.selecting.tool == op.id, kind))
    press(context, op);
  tip(std::string(op.id) + " " + syntax_of(op.line) + "\n" + context.text(op.help_en, op.help_ja) + "\n" +
      context.text(kind.help));
  ImGui::PopID();
}

// The operators of a group that have a key, and the tool; the others when it is unfolded.
void draw_group(PanelContext& context, const OpGroupRow& group, std::span<const KeyRow> keys) {
  const auto is_always_there = [&](const OpInfo& op) { return op.key != '\0' || context.selecting.tool == op.id; };
  std::size_t others = 0;
  for (const OpInfo& op : all_ops()) others += op.group == group.group && !is_always_there(op);
  const std::string more = others > 0 ? "+" + std::to_string(others) : "";
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing() -
                     ImGui::CalcTextSize(more.c_str()).x - ImGui::GetFontSize();
  const std::string name = fitted(context.text(group.en, group.ja), room);
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  const bool is_open = ImGui::TreeNodeEx(
      group.en, ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s", name.c_str());
  ImGui::PopStyleVar();
  tip(context.text(group.help_en, group.help_ja));
  if (!is_open) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(more.c_str()).x - 9 * context.scale);
    ImGui::TextUnformatted(more.c_str());
  }
  ImGui::PopStyleColor();
  const float indent = 6 * context.scale;
  ImGui::Indent(indent);
  for (const OpInfo& op : all_ops())
    if (op.group == group.group && (is_open || is_always_there(op))) draw_operator(context, op, keys);
  ImGui::Unindent(indent);
}

void draw_modes(PanelContext& context) {
  struct Mode {
    PickMode mode;
    UiText name;
  };
  static constexpr Mode modes[] = {{PickMode::vertex, UiText::vertex},
                                   {PickMode::edge, UiText::edge},
                                   {PickMode::face, UiText::face},
                                   {PickMode::halfedge, UiText::halfedge}};
  static_assert(rows_are_in_order(modes, &Mode::mode));
  // In one line where there is room for the words, each with as much beside it; else in two.
  constexpr std::size_t n = std::size(modes);
  const float gap = 3 * context.scale, room = ImGui::GetContentRegionAvail().x;
  const auto width_of = [&](std::size_t i) { return ImGui::CalcTextSize(context.text(modes[i].name)).x; };
  float words = 0;
  for (std::size_t i = 0; i < n; ++i) words += width_of(i);
  const float beside = (room - words - (n - 1) * gap) / n;
  const bool is_one_line = beside >= 3 * context.scale;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 1 * context.scale});
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_active = context.selecting.mode == modes[i].mode;
    const float width = is_one_line ? std::floor(width_of(i) + beside) : (room - gap) / 2;
    if (is_one_line ? i > 0 : i % 2 == 1) ImGui::SameLine(0, gap);
    if (is_active) {
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBgActive));
      ImGui::PushStyleColor(ImGuiCol_Text, context.colours().accent);
    }
    if (ImGui::Button(context.text(modes[i].name), {width, 0})) context.run("mode " + std::string(pick_modes[i].id));
    if (is_active) ImGui::PopStyleColor(2);
    tip(context.text(pick_modes[i].help_en, pick_modes[i].help_ja) + std::string("\n") + context.text(UiText::pick),
        ImGuiHoveredFlags_AllowWhenDisabled);
  }
  ImGui::PopStyleVar();
}

// What the pointer picks, and the operators by what they are for.
void draw_tools(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1 * context.scale});
  ImGui::PushID("select");
  const PressRow& tool = presses[static_cast<std::size_t>(Press::takes_tool)];
  if (marked_row(context, context.text(UiText::select_tool), "Esc", context.selecting.tool.empty(), tool))
    context.run("tool none");
  tip(context.text(tool.help));
  ImGui::PopID();
  // The pick mode applies only without a tool: a tool determines what it picks.
  ImGui::BeginDisabled(!context.selecting.tool.empty());
  draw_modes(context);
  ImGui::EndDisabled();
  const std::vector<KeyRow> keys =
      key_table(input_presets()[context.preferences.input_preset], context.preferences.bindings);
  for (const OpGroupRow& group : op_groups()) draw_group(context, group, keys);
  ImGui::PopStyleVar();
}

}  // namespace

std::unique_ptr<Panel> make_tools_panel() { return panel_of(draw_tools); }

}  // namespace ryosen
