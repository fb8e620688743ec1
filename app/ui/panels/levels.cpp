#include <algorithm>

#include "app/editor/document/findings.h"
#include "app/editor/shown/levels.h"
#include "app/editor/shown/shown.h"
#include "app/ui/overlays.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/document/document.h"

namespace ryosen {

namespace {

// The slider and what can be done on a level. By ratios of faces, as differences are seen.
void draw_slider(PanelContext& context, const ShownLevels& levels) {
  const auto least = static_cast<int>(levels.faces(levels.levels().last()));
  const auto most = static_cast<int>(levels.faces(0));
  auto faces = static_cast<int>(levels.faces());
  const bool is_shown = context.shown.shows(ShownBy::level);
  ImGui::TextUnformatted(
      (grouped(faces) + context.text(" faces", " 面") + (is_shown ? "" : context.text(", not shown", "（非表示）")))
          .c_str());
  ImGui::SetNextItemWidth(-1);
  const bool is_moved =
      ImGui::SliderInt("##level", &faces, least, most, "",
                       ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  tip(context.text("Goes through all collapses, forward and back.", "すべての稜線削除を前後にたどります。"));
  const std::string line = levels.line();
  const float gap = 4 * context.scale, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const bool goes_on = is_shown ? ImGui::Button(context.text("Keep this level", "この段階にする"), {width, 0})
                                : ImGui::Button(context.text("Show this level", "この段階を表示"), {width, 0});
  if (is_shown)
    tip(context.text("Simplifies the mesh to this, as an edit that can be undone.",
                     "この面数に簡略化します。元に戻せる編集になります。") +
        ("\n" + line));
  else
    tip(context.text("Shows it in place of the mesh that is open.", "開いているメッシュの代わりに表示します。"));
  ImGui::SameLine(0, gap);
  const bool closes = ImGui::Button(context.text("Close", "閉じる"), {width, 0});
  tip(context.text("Shows the mesh as it is.", "元のメッシュに戻します。"));
  if (is_moved || (goes_on && !is_shown)) context.run("levels at " + std::to_string(faces));
  if (goes_on && is_shown) context.run("levels keep");
  if (closes) context.run("levels close");
}

void draw_rule(PanelContext& context, const EdgeRuleRow& rule, std::size_t count) {
  const float side = ImGui::GetFontSize() * 0.7f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::uint32_t colour = colour_of(rule.rule, context.theme);
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 0.25f * side}, {at.x + side, at.y + 1.25f * side},
                                            IM_COL32(colour >> 16 & 255, colour >> 8 & 255, colour & 255, 255),
                                            2 * context.scale);
  ImGui::Indent(side + 6 * context.scale);
  ImGui::PushID(rule.id.data());
  const std::string sentence = context.text(rule.en, rule.ja), number = grouped(static_cast<std::int64_t>(count));
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(number.c_str()).x - 24 * context.scale;
  if (row(context, fitted(context.text(rule.name_en, rule.name_ja), room).c_str(), number.c_str(), false))
    context.run("account " + std::string(rule.id));
  tip(sentence + "\n" + context.text("A click selects these edges.", "クリックするとこれらの稜線を選択します。"));
  ImGui::PopID();
  ImGui::Unindent(side + 6 * context.scale);
}

// It costs as much as the simplification.
void draw_asking(PanelContext& context) {
  if (line_to_account_for(context.document(), context.shown).empty()) return;
  ImGui::Separator();
  if (ImGui::Button(context.text("What holds the edges left?", "残った稜線の理由"), {-1, 0})) context.run("account");
  tip(context.text("Finds for each edge that is left the first rule that holds it, and counts them.",
                   "残った稜線ごとに、残った最初の理由を求めて数えます。") +
      std::string("\naccount"));
}

void draw_levels(PanelContext& context) {
  const std::shared_ptr<ShownLevels> levels = context.shown.levels();  // a press may take it away
  if (levels && context.shown.fits()) {
    draw_slider(context, *levels);
  } else {
    if (ImGui::Button(context.text("All levels of this mesh", "全段階を作る"), {-1, 0})) context.run("levels");
    tip(context.text("Simplifies a copy as far as it goes and keeps every step.",
                     "コピーを限界まで簡略化し、すべての手順を残します。") +
        std::string("\nlevels"));
  }
  const LeftEdges* const left_edges = context.findings().left_edges();
  if (!left_edges) return draw_asking(context);
  ImGui::Separator();
  dim_text(context, context.text("What holds the edges that are left", "残った稜線とその理由"));
  const std::vector<std::size_t> counts = left_edges->counts;
  for (const EdgeRuleRow& rule : edge_rule_table())
    if (const std::size_t count = counts[static_cast<std::size_t>(rule.rule)]; count > 0)
      draw_rule(context, rule, count);
}

}  // namespace

std::unique_ptr<Panel> make_levels_panel() { return panel_of(draw_levels); }

}  // namespace ryosen
