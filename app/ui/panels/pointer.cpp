#include <array>

#include "app/editor/input/pick_modes.h"
#include "app/editor/session/pointing.h"
#include "app/editor/session/selecting.h"
#include "app/editor/texts/remedy_text.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

void draw_reason(PanelContext& context, const Reason& reason, const ImVec4& colour) {
  const RuleText& rule = text_of(reason.rule);
  coloured_text(colour, context.text(rule.en, rule.ja));
  if (!reason.witnesses.empty()) element_links(context, reason.witnesses);
}

// "removes 1 V, 3 E, 2 F": what the operator removes or creates.
void draw_change(PanelContext& context, UiText word, const std::vector<Element>& elements) {
  std::array<std::size_t, enum_count<Element::Kind>> n{};
  for (const Element& e : elements) ++n[static_cast<std::size_t>(e.kind)];
  std::string line;
  const auto add = [&](Element::Kind kind, const char* letter) {
    const std::size_t count = n[static_cast<std::size_t>(kind)];
    if (count > 0) line += (line.empty() ? "" : ", ") + std::to_string(count) + " " + letter;
  };
  add(Element::Kind::vertex, "V");
  add(Element::Kind::edge, "E");
  add(Element::Kind::face, "F");
  if (!line.empty()) labelled(context, context.text(word), line);
}

void draw_remedy(PanelContext& context, const Verdict& verdict) {
  const std::vector<std::string> remedy = context.selecting.hover_remedy();
  dim_text(context, context.text(UiText::remedy));
  if (remedy.empty()) {
    wrapped_text(without_remedy(verdict).in(context.language()).c_str());
    return;
  }
  std::string chosen;
  for (const std::string& line : remedy) {
    if (&line == remedy.data()) {  // beside the words, where there is room for it and the name of its key
      const float label = ImGui::GetItemRectSize().x + ImGui::GetStyle().ItemSpacing.x;
      const float wide = ImGui::CalcTextSize(line.c_str()).x + 4 * ImGui::GetFontSize();
      if (label + wide < ImGui::GetContentRegionAvail().x) ImGui::SameLine();
    }
    const bool names_key = context.selecting.is_verdict_held() && &line == remedy.data();
    const float room = ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x -
                       (names_key ? 3.5f * ImGui::GetFontSize() : 0);
    const std::string shown = fitted(line, room);
    if (ImGui::SmallButton((shown + "###" + line).c_str())) chosen = line;
    if (shown != line) tip(line);
    if (!names_key) continue;
    ImGui::SameLine();
    dim_text(context, context.text("Enter", "Enter"));
  }
  if (!chosen.empty()) context.run(chosen);
}

// The element that is pointed at of a mesh that is compared with; false where none is.
bool draw_compared(PanelContext& context) {
  const Pointed* const pointed = context.pointing.pointed();
  if (!pointed || pointed->document == &context.document()) return false;
  wrapped_text(name_and_slot(pointed->document->mesh(), pointed->picked.element).c_str());
  const std::string file = pointed->document->path().filename().string();
  dim_text(context, (context.text("of ", "") + file + context.text(", to be compared with", "（比較用）")).c_str());
  return true;
}

// What a click would do, or why it would not.
void draw_verdict(PanelContext& context) {
  if (draw_compared(context)) return;
  if (!context.selecting.hover()) {
    const PickModeRow& sort = pick_modes[static_cast<std::size_t>(context.selecting.pointed_sort())];
    return dim_text(context, context.text(sort.point_en, sort.point_ja));
  }
  const Hover hover = *context.selecting.hover();
  const OpInfo* const op = hover.op ? &info_of(*hover.op) : nullptr;
  const std::string line =
      op ? command_of(context.mesh(), *hover.op) : name_and_slot(context.mesh(), hover.picked.element);
  if (!op) {
    wrapped_text(line.c_str());
    return;
  }
  const bool legal = hover.preview.verdict.legal();
  const ImVec4 colour = legal ? context.colours().legal : context.colours().refused;
  ImGui::PushFont(context.fonts.bold);
  coloured_text(colour, (std::string(legal ? "\u2713 " : "\u2717 ") + context.text(op->name_en, op->name_ja) + ": " +
                         context.text(legal ? UiText::legal : UiText::refused))
                            .c_str());
  ImGui::PopFont();
  dim_text(context, line.c_str());
  if (legal) {
    draw_change(context, UiText::clears, hover.preview.deleted);
    draw_change(context, UiText::adds, hover.preview.created);
    for (const Reason& warning : hover.preview.warnings) {
      dim_text(context, context.text(UiText::warning));
      draw_reason(context, warning, context.colours().warning);
    }
    return;
  }
  for (const Reason& reason : hover.preview.verdict.reasons)
    draw_reason(context, reason, ImGui::GetStyleColorVec4(ImGuiCol_Text));
  draw_remedy(context, hover.preview.verdict);
}

}  // namespace

std::unique_ptr<Panel> make_pointer_panel() { return panel_of_lines(draw_verdict, 8); }

}  // namespace ryosen
