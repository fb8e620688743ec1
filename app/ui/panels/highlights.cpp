#include "app/ui/overlays.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

std::int64_t members(Session& session, std::string_view highlight) {
  std::int64_t n = 0;
  for (const ProblemRow& kind : problem_table())
    if (kind.is_local() && kind.highlight == highlight) n += session.highlights().count(kind.kind);
  return n;
}

// What is highlighted, how it is drawn, and how much of it there is.
void draw_highlights(PanelContext& context) {
  for (const HighlightRow& highlight : highlight_table()) {
    const std::string id(highlight.id);
    const std::int64_t n = members(context.session, highlight.id);
    ImGui::PushID(id.c_str());
    bool is_shown = context.session.shown.contains(id);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {3 * context.scale, 1 * context.scale});
    if (ImGui::Checkbox("##shown", &is_shown)) context.run("show " + id + (is_shown ? " on" : " off"));
    ImGui::PopStyleVar();
    ImGui::SameLine();
    swatch(style(role_of_highlight(highlight.id), context.theme), 30 * context.scale);
    ImGui::SameLine();
    const char* const name = context.text(highlight.name_en, highlight.name_ja);
    if (n > 0)
      ImGui::TextUnformatted(name);
    else
      ImGui::TextColored(context.colours().dim, "%s", name);
    const std::string count = grouped(n);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x - 8 * context.scale);
    ImGui::TextColored(n > 0 ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : context.colours().dim, "%s", count.c_str());
    ImGui::PopID();
  }
}

}  // namespace

std::unique_ptr<Panel> make_highlights_panel() { return panel_of(draw_highlights); }

}  // namespace ryosen
