#include "app/editor/commands.h"
#include "app/editor/pick_modes.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// The action of an operator's row: toggles the tool, applies the operator to the selection or immediately, or opens the
// command line for its arguments.
void press(PanelContext& context, const OpInfo& op) {
  const std::string id(op.id);
  Session& session = context.session;
  if (is_tool(op)) {
    context.run(session.tool == id ? "tool none" : "tool " + id);
  } else if (op.target == OpTargetKind::selection && !session.selection.empty()) {
    context.run(id + " selected");
  } else if (op.syntax.empty()) {
    context.run(id);
  } else {
    context.begin_command(id + " ");
  }
}

void draw_operator(PanelContext& context, const OpInfo& op) {
  ImGui::PushID(op.id.data());
  const std::string key(op.key == '\0' ? 0 : 1, op.key);
  if (row(context, context.text(op.name_en, op.name_ja), key.c_str(), context.session.tool == op.id))
    press(context, op);
  const std::string help =
      std::string(op.id) + " " + std::string(op.syntax) + "\n" + context.text(op.help_en, op.help_ja);
  tip(help);
  ImGui::PopID();
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
  const float gap = 4 * context.scale, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  for (std::size_t i = 0; i < std::size(modes); ++i) {
    const bool is_active = context.session.mode == modes[i].mode;
    if (i % 2 == 1) ImGui::SameLine(0, gap);
    if (is_active) {
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBgActive));
      ImGui::PushStyleColor(ImGuiCol_Text, context.colours().accent);
    }
    if (ImGui::Button(context.text(modes[i].name), {width, 0})) context.run("mode " + std::string(pick_modes[i].id));
    if (is_active) ImGui::PopStyleColor(2);
  }
}

// The operators and what the pointer picks.
void draw_tools(PanelContext& context) {
  ImGui::PushID("select");
  if (row(context, context.text(UiText::select_tool), "Esc", context.session.tool.empty())) context.run("tool none");
  ImGui::PopID();
  for (const OpInfo& op : all_ops())
    if (op.key != '\0') draw_operator(context, op);
  if (ImGui::TreeNodeEx("more", ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
                        context.text(UiText::more_operators)))
    for (const OpInfo& op : all_ops())
      if (op.key == '\0') draw_operator(context, op);
  // The pick mode applies only without a tool: a tool determines what it picks.
  ImGui::BeginDisabled(!context.session.tool.empty());
  dim_text(context, context.text(UiText::pick));
  draw_modes(context);
  ImGui::EndDisabled();
}

}  // namespace

std::unique_ptr<Panel> make_tools_panel() { return panel_of(draw_tools); }

}  // namespace ryosen
