#include <algorithm>
#include <cstdlib>

#include "app/editor/document/findings.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// A dash where there is no value.
std::string figure_text(std::optional<std::int64_t> value) { return value ? grouped(*value) : "\u2212"; }

// The tooltip of a row of the table, from one side of the panel to the other.
void tip_of_row(const char* text, float top_px) {
  const ImVec2 panel = ImGui::GetWindowPos(), last{panel.x + ImGui::GetWindowWidth(), ImGui::GetItemRectMax().y};
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect({panel.x, top_px}, last, false)) tip_shown(text);
}

void draw_term(PanelContext& context, const EulerTerm& term, const EulerPoincare& terms) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const float top = ImGui::GetCursorScreenPos().y;
  ImGui::PushFont(context.fonts.bold);
  ImGui::TextColored(context.colours().accent, "%c", term.letter);
  ImGui::PopFont();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
  fitted_text(context.text(term.en, term.ja), ImGui::GetContentRegionAvail().x);
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  const std::string figure = figure_text(term.value(terms));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x -
                       ImGui::CalcTextSize(figure.c_str()).x);
  ImGui::TextUnformatted(figure.c_str());
  const Text why_none = why_no_value(context.mesh(), terms, term);
  std::string tip = context.text(term.help_en, term.help_ja);
  if (!why_none.en.empty()) tip += "\n" + why_none.in(context.language());
  tip_of_row(tip.c_str(), top);
}

// Parts of a line, each as a whole on the next one where there is no room left.
class Flow {
 public:
  void add(const std::string& part, const ImVec4& colour = ImGui::GetStyleColorVec4(ImGuiCol_Text)) {
    const float gap = 0.3f * ImGui::GetFontSize(), end = ImGui::GetItemRectMax().x + gap;
    const float edge = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (has_begun_ && end + ImGui::CalcTextSize(part.c_str()).x <= edge) ImGui::SameLine(0, gap);
    has_begun_ = true;
    ImGui::TextColored(colour, "%s", part.c_str());
  }

 private:
  bool has_begun_ = false;
};

// The law, then what the mesh has of it on its left and what its parts, handles and loops lead to expect, with a tick
// where that is the same; where there is no G, the reason instead.
void draw_sum(PanelContext& context, const EulerPoincare& terms) {
  const auto in = [&](const char* en, const char* ja) { return std::string(context.text(en, ja)); };
  const std::string minus = "\u2212 ";
  Flow formula;
  for (const char* const part : {"V\u2212E+F+(B+W+I)\u2212H", "= 2(S\u2212G)"})
    formula.add(part, context.colours().dim);
  Flow sum;
  const std::string left =
      "V " + minus + "E + F " + (terms.rings != 0 ? minus + "H " : "") + "= " + grouped(terms.left() - terms.outside());
  sum.add(left + (terms.genus ? in(",", "、") : ""));
  if (terms.genus) {
    const bool holds = terms.holds();
    sum.add(holds ? in("as expected:", "期待どおり：") : in("expected:", "期待値："));
    sum.add("2 (" + grouped(terms.parts) + " " + minus + grouped(*terms.genus) + ")");
    sum.add((terms.outside() < 0 ? "+ " : minus) + grouped(std::abs(terms.outside())));
    if (!holds) sum.add("= " + grouped(terms.right() - terms.outside()));
    sum.add(holds ? "\u2713" : "\u2717", holds ? context.colours().legal : context.colours().refused);
    return;
  }
  const std::string reason =
      std::string(context.text(UiText::no_genus)) + ": " + why_no_genus(context.mesh(), terms).in(context.language());
  coloured_text(context.colours().warning, reason.c_str());
  if (terms.open_chain) coloured_text(context.colours().warning, no_loop_count.in(context.language()).c_str());
}

// What the mesh is, in the word of `check`; the reason is its tooltip.
void draw_kind_of_mesh(PanelContext& context) {
  const KindOfMesh& kind = context.findings().kind();
  const MeshKindRow& row = row_of(kind.kind);
  const bool is_stale = context.findings().is_kind_stale();
  dim_text(context, context.text(UiText::kind));
  ImGui::SameLine();
  const ImVec4 colour = is_stale ? context.colours().dim : ImGui::GetStyleColorVec4(ImGuiCol_Text);
  ImGui::PushFont(context.fonts.bold);
  coloured_text(colour, context.text(row.name_en, row.name_ja));
  ImGui::PopFont();
  tip(kind.reason.in(context.language()));
  if (!is_stale) return;
  if (ImGui::SmallButton(context.text(UiText::kind_anew))) context.findings().kind(true);
  tip(context.text(UiText::kind_is_stale));
}

// Why there are more vertices and edges in the mesh than the terms say.
void draw_copies(PanelContext& context, const EulerPoincare& terms) {
  const Mesh& mesh = context.mesh();
  const auto held = static_cast<std::int64_t>(mesh.live().vertices);
  if (held == terms.vertices) return;
  const std::string points = grouped(terms.vertices), vertices = grouped(held);
  const Text sentence{
      points + " points, held as " + vertices +
          " vertices because sheets of faces that do not fit together each have their own.",
      points + " 点を " + vertices + " 頂点で表しています。つながらない面の集まりが、それぞれ頂点をもつためです。"};
  dim_text(context, std::string(sentence.in(context.language())).c_str());
  tip(context.text(
      "Where more than two faces share an edge, where neighbours are turned against each other, or where "
      "faces touch at a point alone. Files and names keep the one point.",
      "三つ以上の面が一つの稜線を共有するところ、隣の面と向きが逆のところ、面が一点だけで接するところです。"
      "ファイルと名前では一つの点のままです。"));
}

// The terms of V - E + F + (B + W + I) - H = 2(S - G).
void draw_totals(PanelContext& context) {
  const EulerPoincare& terms = context.findings().euler_terms();
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4 * context.scale, 1 * context.scale});
  float widest = 0;
  for (const EulerTerm& term : euler_letters())
    widest = std::max(widest, ImGui::CalcTextSize(figure_text(term.value(terms)).c_str()).x);
  if (ImGui::BeginTable("terms", 3)) {
    ImGui::TableSetupColumn("letter", ImGuiTableColumnFlags_WidthFixed, 1.1f * ImGui::GetFontSize());
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, widest + 4 * context.scale);
    for (const EulerTerm& term : euler_letters())
      if (!term.is_rare || term.value(terms) != 0) draw_term(context, term, terms);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2 * context.scale});
  draw_sum(context, terms);
  draw_kind_of_mesh(context);
  draw_copies(context, terms);
  ImGui::PopStyleVar();
}

}  // namespace

std::unique_ptr<Panel> make_totals_panel() { return panel_of(draw_totals); }

}  // namespace ryosen
