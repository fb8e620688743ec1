#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/ui/panels.h"
#include "app/ui/swatch.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

void draw_highlight(PanelContext& context, const HighlightRow& row) {
  const std::string id(row.id);
  bool is_shown = context.view.highlights.contains(id);
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
  const HighlightSets& sets = context.findings().highlights();
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

// Problems first, then what is none.
std::vector<const HighlightRow*> rows_that_are_there(Findings& findings) {
  std::vector<const HighlightRow*> rows;
  for (const HighlightRow& row : highlight_table())
    if (!row.kinds.empty() && (!row.is_on_request() || findings.highlights().count(row) > 0)) rows.push_back(&row);
  for (const HighlightRow& row : highlight_table())
    if (row.kinds.empty()) rows.push_back(&row);
  return rows;
}

// What is highlighted, how it is drawn, and how much of it there is. Where the column is too long for its window, the
// rows that say nothing stand behind one, until that is unfolded: there is none of it, and nobody has switched it.
class HighlightsPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    const HighlightSets& sets = context.findings().highlights();
    const auto says_something = [&](const HighlightRow& row) {
      return (sets.keeps(row) && sets.count(row) > 0) ||
             context.view.highlights.contains(std::string(row.id)) != row.is_shown_at_first();
    };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2 * context.scale});
    int left_out = 0;
    for (const HighlightRow* row : rows_that_are_there(context.findings()))
      if (context.state.is_tight && !shows_all_ && !says_something(*row))
        ++left_out;
      else
        draw_highlight(context, *row);
    if (!context.state.is_tight) shows_all_ = false;
    if (left_out > 0 || shows_all_) draw_switch(context, left_out);
    ImGui::PopStyleVar();
  }

 private:
  void draw_switch(PanelContext& context, int left_out) {
    const float top = ImGui::GetCursorPosY();
    const std::string n = std::to_string(left_out);
    const std::string name = shows_all_                                 ? context.text("fewer", "折りたたむ")
                             : context.language() == Language::japanese ? "ほか " + n + " 種（該当なし）"
                                                                        : n + " more, none of it here";
    if (row(context, name.c_str(), "", false)) shows_all_ = !shows_all_;
    const float pitch = ImGui::GetCursorPosY() - top;
    context.state.saved_px += static_cast<float>(left_out - 1) * pitch;
  }

  bool shows_all_ = false;
};

}  // namespace

std::unique_ptr<Panel> make_highlights_panel() { return std::make_unique<HighlightsPanel>(); }

}  // namespace ryosen
