#include "app/ui/repair_rows.h"

#include <algorithm>
#include <cmath>

#include "app/editor/commands/commands.h"
#include "app/editor/document/repair_call.h"
#include "app/editor/document/repair_trials.h"
#include "app/editor/shown/shown.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

RepairRows::Fields& RepairRows::fields_of(const AlgorithmRow& row) {
  const auto [at, is_new] = fields_.try_emplace(std::string(row.id));
  if (is_new)
    for (const ParameterRow& parameter : row.parameters) at->second.texts.emplace_back(parameter.initial);
  return at->second;
}

namespace {

constexpr std::size_t row_lines = 3, tip_lines = 8;

// What a trial found out: all of it, or so many of its parts that it fits into so many lines; at least two parts.
std::string brief(PanelContext& context, const RepairReport& report, float width_px, std::size_t most_lines) {
  const Text begin = report.fault ? Text() : Text{"Trial: ", "結果の見込み："};
  for (std::size_t parts = std::max<std::size_t>(report.findings.size() + report.left.size(), 2);; --parts) {
    std::string text = (begin + told(report, context.mesh(), parts)).in(context.language());
    if (parts == 2 || lines_of(text, width_px) <= most_lines) return text;
  }
}

// The same where it fits, else what is shorter: at last only how much changes and is left.
std::string brief_or_numbers(PanelContext& context, const RepairReport& report, float width_px,
                             std::size_t most_lines) {
  const auto fits = [&](const std::string& text) { return lines_of(text, width_px) <= most_lines; };
  const std::string some = brief(context, report, width_px, most_lines);
  if (report.fault || fits(some)) return some;
  const Text begin{"Trial: ", "結果の見込み："};
  for (const auto shorter : {in_short, in_one_clause})
    if (const std::string text = (begin + shorter(report)).in(context.language()); fits(text)) return text;
  return (begin + in_numbers(report)).in(context.language());
}

// What is missing or wrong, where there is no room for it all without what would be right.
std::string brief_fault(const PanelContext& context, const Text& fault, float width_px) {
  std::string text = fault.in(context.language());
  if (lines_of(text, width_px) <= row_lines) return text;
  return text.substr(0, std::min({text.size(), text.find(": "), text.find("：")}));
}

// As high whatever it says, so that what is below stays where it is.
void draw_row_text(const ImVec4& colour, const std::string& text) {
  const ImVec2 begin = ImGui::GetCursorPos();
  coloured_text(colour, fitted_lines(text, ImGui::GetContentRegionAvail().x, row_lines).c_str());
  const float pitch = ImGui::GetTextLineHeightWithSpacing(), gap = ImGui::GetStyle().ItemSpacing.y;
  ImGui::SetCursorPos({begin.x, begin.y + row_lines * pitch - gap});
  ImGui::Dummy({0, 0});
}

}  // namespace

// Why no repair can be pressed; empty where they can.
Text RepairRows::why_off(const Shown& shown, bool is_mended) {
  if (is_mended) return {"Nothing is left to mend.", "直すものは残っていません。"};
  if (shown.response(Effect::edits) != Response::refuse) return {};
  return {"Repairs are done on the mesh that is open; Esc shows it.",
          "修復は開いているメッシュに行います。Esc でその表示に戻ります。"};
}

// More of it beside the button that is pointed at.
void RepairRows::draw_report(PanelContext& context, const std::string& line, const char* name, const char* help,
                             const Text& why_off) {
  const float width = ImGui::GetContentRegionAvail().x, pitch = ImGui::GetTextLineHeightWithSpacing();
  const ImVec2 begin = ImGui::GetItemRectMin();
  const ImVec2 end{begin.x + width, ImGui::GetCursorScreenPos().y + row_lines * pitch};
  const bool is_pointed = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(begin, end);
  const RepairReport* report = nullptr;
  const bool is_asked = why_off.en.empty() && (is_pointed || !is_costly_to_try(context.mesh()));
  Text said{"Point here to try it on a copy.", "ここを指すと、写しで試します。"};
  if (!why_off.en.empty()) said = why_off;
  if (is_asked) {
    wants_trial_ = true;
    report = tried(context.document(), context.trials, line);
    const int percent = static_cast<int>(std::lround(100 * context.trials.share().value_or(0)));
    const std::string n = std::to_string(percent);
    said = {"Trying it on a copy: " + n + " %", "写しで試しています：" + n + " %"};
  }
  const std::string asked = said.in(context.language());
  draw_row_text(context.colours().dim, report ? brief_or_numbers(context, *report, width, row_lines) : asked);
  ImGui::EndGroup();
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const std::string whole = report ? brief(context, *report, 22 * ImGui::GetFontSize(), tip_lines) : asked;
  tip_shown(std::string(name) + "\n" + help + "\n\n" + whole);
}

bool RepairRows::draw_fields(PanelContext& context, const AlgorithmRow& row, Fields& fields) {
  bool entered = false;
  ImGui::Indent(ImGui::GetFontSize());
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const ParameterRow& parameter = row.parameters[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    fitted_text(context.text(parameter.name_en, parameter.name_ja), 0.5f * ImGui::GetContentRegionAvail().x);
    ImGui::SameLine();
    if (std::exchange(fields.begin, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    entered = draw_parameter_field(context, parameter, fields.texts[i]) || entered;
    tip(std::string(context.text(parameter.help_en, parameter.help_ja)) + "\n" +
        described(parameter).in(context.language()));
    ImGui::PopID();
  }
  ImGui::Unindent(ImGui::GetFontSize());
  return entered;
}

bool RepairRows::draw_repair(PanelContext& context, const AlgorithmRow& row, const Text& why_off) {
  Fields& fields = fields_of(row);
  const ReadValues read = read_fields(row.parameters, fields.texts);
  ImGui::PushID(row.id.data(), row.id.data() + row.id.size());
  const bool has_fields = !row.parameters.empty();
  if (has_fields) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
    if (ImGui::ArrowButton("fields", fields.are_open ? ImGuiDir_Down : ImGuiDir_Right)) fields.are_open ^= true;
    ImGui::PopStyleVar();
    tip(context.text("its numbers", "数値の入力欄"));
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  }
  const char* const name = context.text(row.name_en, row.name_ja);
  const char* const help = context.text(row.help_en, row.help_ja);
  const std::string shown = fitted(name, ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x);
  const bool is_refused = !read.values && fields.are_open;
  ImGui::BeginGroup();
  ImGui::BeginDisabled(!why_off.en.empty() || is_refused);
  bool is_pressed = ImGui::SmallButton(shown.c_str());
  ImGui::EndDisabled();
  std::string line = called(row, true);
  if (read.values) {
    const std::string values = read.values->line();
    line += values.empty() ? "" : " " + values;
    draw_report(context, line, name, help, why_off);
  } else {
    const std::string fault = read.sentence.in(context.language());
    draw_row_text(context.colours().warning, brief_fault(context, read.sentence, ImGui::GetContentRegionAvail().x));
    ImGui::EndGroup();
    tip(std::string(name) + "\n" + help + "\n\n" + fault, ImGuiHoveredFlags_AllowWhenDisabled);
  }
  if (is_pressed && !read.values) {
    fields.are_open = fields.begin = true;
    for (std::size_t i = 0; i < fields.texts.size(); ++i)
      if (fields.texts[i].empty()) fields.texts[i] = first_text(row.parameters[i], context.mesh());
    is_pressed = false;
  }
  if (fields.are_open) is_pressed |= draw_fields(context, row, fields) && read.values && why_off.en.empty();
  if (is_pressed) context.run(line);
  ImGui::PopID();
  return is_pressed;
}

bool RepairRows::draw(PanelContext& context, ProblemKind kind, bool is_mended) {
  bool is_pressed = false;
  const Text off = why_off(context.shown, is_mended);
  for (const AlgorithmRow& repair : algorithm_table())
    if (std::find(repair.solves.begin(), repair.solves.end(), kind) != repair.solves.end())
      is_pressed |= draw_repair(context, repair, off);
  return is_pressed;
}

bool RepairRows::draw_all(PanelContext& context, bool is_mended) {
  const std::string line(repair_all_line);
  const char* const name = context.text("Repair all", "まとめて修復");
  std::string help =
      context.text("Does all repairs that keep every place and the faces on them, again until nothing changes: ",
                   "形状を保つ修復を、変化がなくなるまで繰り返します：");
  bool is_first = true;
  for (const RecipeStep& step : read_repairs(default_repairs).call.steps) {
    if (!std::exchange(is_first, false)) help += context.text(", ", "、");
    help += context.text(step.row->name_en, step.row->name_ja);
  }
  const Text off = why_off(context.shown, is_mended);
  ImGui::BeginGroup();
  ImGui::BeginDisabled(!off.en.empty());
  const bool is_pressed = ImGui::Button(name, {ImGui::GetContentRegionAvail().x, 0});
  ImGui::EndDisabled();
  draw_report(context, line, name, help.c_str(), off);
  if (is_pressed) context.run(line);
  return is_pressed;
}

bool RepairRows::draw_beyond_all(PanelContext& context, ProblemKind kind, bool is_mended) {
  const ProblemRow& row = row_of(kind);
  const Text said =
      Text{"Repair all moves no point, and leaves this: ", "「まとめて修復」は点を動かさず、次を残します："} +
      Text{std::string(row.name_en) + ".", std::string(row.name_ja) + "。"};
  ImGui::PushID("beyond");
  dim_text(context, said.in(context.language()).c_str());
  bool is_pressed = false;
  const Text off = why_off(context.shown, is_mended);
  for (const AlgorithmRow& repair : algorithm_table())
    if (!repair.keeps_geometry && repair.parameters.empty() &&
        std::find(repair.solves.begin(), repair.solves.end(), kind) != repair.solves.end())
      is_pressed |= draw_repair(context, repair, off);
  ImGui::PopID();
  return is_pressed;
}

void RepairRows::end_frame(PanelContext& context) {
  if (!std::exchange(wants_trial_, false)) context.trials.cancel();
}

}  // namespace ryosen
