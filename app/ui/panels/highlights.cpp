#include "app/ui/panels.h"
#include "app/ui/swatch.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

void draw_highlight(PanelContext& context, const HighlightRow& row) {
  const std::string id(row.id);
  bool is_shown = context.session.shown.contains(id);
  ImGui::PushID(id.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {3 * context.scale, 0});
  if (ImGui::Checkbox("##shown", &is_shown)) context.run("show " + id + (is_shown ? " on" : " off"));
  ImGui::PopStyleVar();
  ImGui::SameLine();
  const char* const legend = context.text(row.legend_en, row.legend_ja);
  swatch(row, context.theme, 30 * context.scale, context.scale);
  tip(legend);
  ImGui::SameLine();
  // What nobody looks at is not searched for, so it has no count.
  const HighlightSets& sets = context.session.highlights();
  const bool is_counted = sets.keeps(row);
  const auto n = is_counted ? static_cast<std::int64_t>(sets.count(row)) : 0;
  const char* const name = context.text(row.name_en, row.name_ja);
  const std::string count = is_counted ? grouped(n) : "\u2013";
  const float end = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x - 8 * context.scale;
  const std::string shown = fitted(name, end - ImGui::GetCursorPosX() - ImGui::GetStyle().ItemSpacing.x);
  const ImVec4 colour = n > 0 ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : context.colours().dim;
  ImGui::TextColored(colour, "%s", shown.c_str());
  tip(shown == name ? legend : std::string(name) + "\n" + legend);
  ImGui::SameLine(end);
  ImGui::TextColored(colour, "%s", count.c_str());
  ImGui::PopID();
}

// What is highlighted, how it is drawn, and how much of it there is: problems first, then what is none.
void draw_highlights(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2 * context.scale});
  const auto is_there = [&](const HighlightRow& row) {
    return !row.is_on_request() || context.session.highlights().count(row) > 0;
  };
  for (const HighlightRow& row : highlight_table())
    if (!row.kinds.empty() && is_there(row)) draw_highlight(context, row);
  for (const HighlightRow& row : highlight_table())
    if (row.kinds.empty()) draw_highlight(context, row);
  ImGui::PopStyleVar();
}

}  // namespace

std::unique_ptr<Panel> make_highlights_panel() { return panel_of(draw_highlights); }

}  // namespace ryosen
