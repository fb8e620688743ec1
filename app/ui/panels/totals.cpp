#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// A dash where there is no value.
void draw_term(PanelContext& context, const char* letter, std::optional<std::int64_t> value, UiText name) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(context.fonts.bold);
  ImGui::TextColored(context.colours().accent, "%s", letter);
  ImGui::PopFont();
  ImGui::TableNextColumn();
  ImGui::TextColored(context.colours().dim, "%s", context.text(name));
  ImGui::TableNextColumn();
  const std::string figure = value ? grouped(*value) : "\u2212";
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x -
                       ImGui::CalcTextSize(figure.c_str()).x);
  ImGui::TextUnformatted(figure.c_str());
}

// The sum with its numbers, and a tick where both sides are equal; where there is no G, the reason instead.
void draw_sum(PanelContext& context, const EulerPoincare& terms) {
  const auto n = [](std::int64_t value) { return std::to_string(value); };
  dim_text(context, "V\u2212E+F+(B+W+I)\u2212H = 2(S\u2212G)");
  const std::string counts = n(terms.vertices) + " \u2212 " + n(terms.edges) + " + " + n(terms.faces);
  std::string rest = " + " + n(terms.outside()) + " \u2212 " + n(terms.rings) + " = " + n(terms.left());
  if (terms.genus)
    rest += std::string(terms.holds() ? " = " : " \u2260 ") + n(terms.right()) + " = 2 (" + n(terms.parts) +
            " \u2212 " + n(*terms.genus) + ")";
  ImGui::TextUnformatted(counts.c_str());
  if (ImGui::CalcTextSize((counts + rest).c_str()).x + 2 * ImGui::GetFontSize() < ImGui::GetContentRegionAvail().x)
    ImGui::SameLine(0, 0.3f * ImGui::GetFontSize());
  ImGui::TextUnformatted(rest.c_str());
  if (terms.genus) {
    ImGui::SameLine();
    ImGui::TextColored(terms.holds() ? context.colours().legal : context.colours().refused, "%s",
                       terms.holds() ? "\u2713" : "\u2717");
    return;
  }
  const std::string reason = std::string(context.text(UiText::no_genus)) + ": " +
                             why_no_genus(context.session.mesh(), terms).in(context.language());
  ImGui::PushTextWrapPos(0);
  coloured_text(context.colours().warning, reason.c_str());
  ImGui::PopTextWrapPos();
}

// What the mesh is, in the word of `check`; the reason is its tooltip.
void draw_kind_of_mesh(PanelContext& context) {
  const KindOfMesh& kind = context.session.kind();
  const MeshKindRow& row = row_of(kind.kind);
  const bool is_stale = context.session.is_kind_stale();
  dim_text(context, context.text(UiText::kind));
  ImGui::SameLine();
  const ImVec4 colour = is_stale ? context.colours().dim : ImGui::GetStyleColorVec4(ImGuiCol_Text);
  ImGui::PushFont(context.fonts.bold);
  coloured_text(colour, context.text(row.name_en, row.name_ja));
  ImGui::PopFont();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", kind.reason.in(context.language()).c_str());
  if (!is_stale) return;
  ImGui::SameLine();
  if (ImGui::SmallButton(context.text(UiText::kind_anew))) context.session.kind(true);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", context.text(UiText::kind_is_stale));
}

// The terms of V - E + F + (B + W + I) - H = 2(S - G).
void draw_totals(PanelContext& context) {
  const EulerPoincare& terms = context.session.euler_terms();
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4 * context.scale, 1 * context.scale});
  if (ImGui::BeginTable("terms", 3)) {
    ImGui::TableSetupColumn("letter", ImGuiTableColumnFlags_WidthFixed, 1.1f * ImGui::GetFontSize());
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 3);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1.6f);
    draw_term(context, "V", terms.vertices, UiText::vertices);
    draw_term(context, "E", terms.edges, UiText::edges);
    draw_term(context, "F", terms.faces, UiText::faces);
    draw_term(context, "B", terms.boundary_loops, UiText::boundaries);
    // Most meshes have none of these two, and the column is low.
    if (terms.wire_cycles != 0) draw_term(context, "W", terms.wire_cycles, UiText::wire_cycles);
    if (terms.isolated != 0) draw_term(context, "I", terms.isolated, UiText::points_without_edge);
    draw_term(context, "H", terms.rings, UiText::rings);
    draw_term(context, "S", terms.parts, UiText::parts);
    draw_term(context, "G", terms.genus, UiText::genus);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  draw_sum(context, terms);
  draw_kind_of_mesh(context);
}

}  // namespace

std::unique_ptr<Panel> make_totals_panel() { return panel_of(draw_totals); }

}  // namespace ryosen
