#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

void draw_term(PanelContext& context, const char* letter, std::int64_t value, UiText name) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(context.fonts.bold);
  ImGui::TextColored(context.colours().accent, "%s", letter);
  ImGui::PopFont();
  ImGui::TableNextColumn();
  ImGui::TextColored(context.colours().dim, "%s", context.text(name));
  ImGui::TableNextColumn();
  const std::string figure = grouped(value);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x -
                       ImGui::CalcTextSize(figure.c_str()).x);
  ImGui::TextUnformatted(figure.c_str());
}

void draw_sum(PanelContext& context, const EulerPoincare& terms) {
  const auto n = [](std::int64_t value) { return std::to_string(value); };
  dim_text(context, "V \u2212 E + F + B \u2212 H = 2 (S \u2212 G)");
  const std::string counts = n(terms.vertices) + " \u2212 " + n(terms.edges) + " + " + n(terms.faces);
  const std::string rest = " + " + n(terms.boundaries) + " \u2212 " + n(terms.rings) + " = " + n(terms.left()) +
                           " = 2 (" + n(terms.components) + " \u2212 " + n(terms.genus) + ")";
  ImGui::TextUnformatted(counts.c_str());
  if (ImGui::CalcTextSize((counts + rest).c_str()).x + 2 * ImGui::GetFontSize() < ImGui::GetContentRegionAvail().x)
    ImGui::SameLine(0, 0.3f * ImGui::GetFontSize());
  ImGui::TextUnformatted(rest.c_str());
  const bool holds = terms.left() == terms.right();
  ImGui::SameLine();
  ImGui::TextColored(holds ? context.colours().legal : context.colours().refused, "%s", holds ? "\u2713" : "\u2260");
}

// The figures of `check`, where copies and cut edges make the kernel's larger.
void draw_on_points(PanelContext& context) {
  const ElementCounts kernel = context.session.mesh().live();
  const ElementCounts n = context.session.highlights().counts_on_points(context.session.mesh());
  if (n.vertices == kernel.vertices && n.edges == kernel.edges) return;
  const std::string line =
      std::string(context.text(UiText::on_points)) + ": V " + grouped(n.vertices) + "  E " + grouped(n.edges);
  coloured_text(context.colours().warning, line.c_str());
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
  ImGui::TextUnformatted(context.text(UiText::on_points_reason));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

// The terms of V - E + F + B - H = 2(S - G).
void draw_totals(PanelContext& context) {
  const EulerPoincare& terms = context.session.euler_terms();
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4 * context.scale, 1.5f * context.scale});
  if (ImGui::BeginTable("terms", 3)) {
    ImGui::TableSetupColumn("letter", ImGuiTableColumnFlags_WidthFixed, 1.1f * ImGui::GetFontSize());
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 3);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1.6f);
    draw_term(context, "V", terms.vertices, UiText::vertices);
    draw_term(context, "E", terms.edges, UiText::edges);
    draw_term(context, "F", terms.faces, UiText::faces);
    draw_term(context, "B", terms.boundaries, UiText::boundaries);
    draw_term(context, "H", terms.rings, UiText::rings);
    draw_term(context, "S", terms.components, UiText::components);
    draw_term(context, "G", terms.genus, UiText::genus);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  draw_on_points(context);
  draw_sum(context, terms);
}

}  // namespace

std::unique_ptr<Panel> make_totals_panel() { return panel_of(draw_totals); }

}  // namespace ryosen
