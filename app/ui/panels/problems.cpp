#include <algorithm>

#include "app/ui/panels/all.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// Selects the element and brings it into view; a quarantined face is in the file only.
void go_to(PanelContext& context, const ProblemRow& row, Element element) {
  if (row.quarantined) return;
  context.run("select " + name_of(context.session.mesh(), element));
  if (!context.session.selection.empty()) context.run("frame selected");
}

// Only the elements in sight are looked up and named.
void draw_elements(PanelContext& context, const ProblemRow& row, std::size_t count) {
  Session& session = context.session;
  const float line_height = ImGui::GetTextLineHeightWithSpacing();
  const auto n = static_cast<int>(count);
  ImGui::BeginChild("elements", {0, static_cast<float>(std::min(n, 6)) * line_height + 4 * context.scale});
  ImGuiListClipper clipper;
  clipper.Begin(n, line_height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Element element = context.state.finding(session, row, static_cast<std::size_t>(i));
      const bool is_selected = !session.selection.empty() && session.selection[0] == element;
      ImGui::PushID(i);
      if (ImGui::Selectable(name_on_points(session.mesh(), element).c_str(), is_selected)) go_to(context, row, element);
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
}

// The repairs of a kind: one press does it; where a number is needed, the command waits for it.
bool draw_repairs(PanelContext& context, ProblemKind kind) {
  bool is_pressed = false;
  for (const RepairRow& repair : repair_table()) {
    if (std::find(repair.solves.begin(), repair.solves.end(), kind) == repair.solves.end()) continue;
    ImGui::PushID(repair.id.data());
    const std::string command = "repair " + std::string(repair.id);
    if (ImGui::SmallButton(context.text(repair.name_en, repair.name_ja))) {
      is_pressed = true;
      if (repair.number == RepairNumber::must_be_given) {
        context.state.command = command + " ";
        context.run("panel command");
      } else {
        context.run(command);
      }
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", context.text(repair.help_en, repair.help_ja));
    ImGui::PopID();
  }
  return is_pressed;
}

void draw_kind(PanelContext& context, const ProblemRow& row, std::size_t count) {
  const bool is_problem = row.severity == ProblemSeverity::problem;
  ImGui::PushID(static_cast<int>(row.kind));
  const std::string label = grouped(static_cast<std::int64_t>(count)) + "  " + context.text(row.name_en, row.name_ja);
  ImGui::PushStyleColor(ImGuiCol_Text,
                        is_problem ? context.colours().refused : ImGui::GetStyleColorVec4(ImGuiCol_Text));
  const bool is_open = ImGui::TreeNodeEx("kind", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", label.c_str());
  ImGui::PopStyleColor();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.sentence(count).in(context.language()).c_str());
  if (is_open) {
    // A repair may have taken away what was counted.
    if (!draw_repairs(context, row.kind)) draw_elements(context, row, count);
    ImGui::TreePop();
  }
  ImGui::PopID();
}

}  // namespace

void draw_problems(PanelContext& context) {
  bool found = false;
  for (const ProblemRow& row : problem_table()) {
    const std::size_t count = context.state.findings(context.session, row);
    if (count == 0) continue;
    found = true;
    draw_kind(context, row, count);
  }
  if (!found) coloured_text(context.colours().legal, context.text(UiText::no_problems));
}

}  // namespace ryosen
