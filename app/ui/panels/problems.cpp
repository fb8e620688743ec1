#include "app/ui/panels/all.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// Selects the element and brings it into view; a quarantined face is in the file only.
void go_to(PanelContext& context, const Problem& problem, Element element) {
  if (problem.row().quarantined) return;
  context.run("select " + name_of(context.session.mesh(), element));
  if (!context.session.selection.empty()) context.run("frame selected");
}

void draw_elements(PanelContext& context, const Problem& problem) {
  const Session& session = context.session;
  const float line_height = ImGui::GetTextLineHeightWithSpacing();
  const auto n = static_cast<int>(problem.count());
  ImGui::BeginChild("elements", {0, static_cast<float>(std::min(n, 6)) * line_height + 4 * context.scale});
  ImGuiListClipper clipper;
  clipper.Begin(n, line_height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Element element = problem.elements[static_cast<std::size_t>(i)];
      const bool is_selected = !session.selection.empty() && session.selection[0] == element;
      ImGui::PushID(i);
      if (ImGui::Selectable(name_on_points(session.mesh(), element).c_str(), is_selected))
        go_to(context, problem, element);
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
}

}  // namespace

void draw_problems(PanelContext& context) {
  if (context.state.problems.empty()) return coloured_text(context.colours().legal, context.text(UiText::no_problems));
  // A click may change what is found; it is looked for again in the next frame.
  const std::vector<Problem>& problems = context.state.problems;
  for (const Problem& problem : problems) {
    const ProblemRow& kind = problem.row();
    const bool is_problem = kind.severity == ProblemSeverity::problem;
    ImGui::PushID(static_cast<int>(problem.kind));
    const std::string label =
        grouped(static_cast<std::int64_t>(problem.count())) + "  " + context.text(kind.name_en, kind.name_ja);
    ImGui::PushStyleColor(ImGuiCol_Text,
                          is_problem ? context.colours().refused : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    const bool is_open = ImGui::TreeNodeEx("kind", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", label.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", problem.text.in(context.language()).c_str());
    if (is_open) {
      draw_elements(context, problem);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
}

}  // namespace ryosen
