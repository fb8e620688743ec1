// The values of an algorithm: one field per parameter, as its row describes it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "app/editor/camera/framing.h"
#include "app/editor/camera/view_state.h"
#include "app/editor/commands/commands.h"
#include "app/editor/document/findings.h"
#include "app/editor/document/repair_trials.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/algorithm_preview.h"
#include "app/editor/shown/shown.h"
#include "app/ui/panels.h"
#include "app/ui/whole_rows.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

bool shows_what_it_takes(const ParameterRow& row) {
  return row.kind == ParameterKind::flag || row.kind == ParameterKind::choice;
}

// What a field takes, where it does not show that itself; which of several must be given stands below all of them.
std::string hint_of(const PanelContext& context, const ParameterRow& row) {
  if (shows_what_it_takes(row)) return {};
  const bool may_lack = row.initial.empty() && !row.is_required && row.one_of.empty();
  return expected_value(row).in(context.language()) + (may_lack ? context.text("; may be left out", "、省略可") : "");
}

// The first field that must be filled in and is empty.
std::optional<std::size_t> lacking(std::span<const ParameterRow> rows, std::span<const std::string> texts) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (texts[i].empty() && must_be_given(rows, rows[i])) return i;
  return std::nullopt;
}

// With these names in place of the word for the selection.
ParameterValues with_names(ParameterValues values, const std::vector<std::string>& names) {
  for (const ParameterRow& row : values.rows())
    if (means_selection(row, values.text(row.id))) values.set_names(row.id, names);
  return values;
}

// One field per parameter of the algorithm that is asked for; without one, all of them to choose from.
class ValuesPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    const AlgorithmRow* const row = find_algorithm(context.layout.asked_algorithm);
    if (!row) return draw_algorithms(context);
    const bool has_failed = algorithm_ == row->id && has_run_ && context.state.last.kind != Outcome::Kind::done;
    const bool begins = algorithm_ != row->id || ImGui::IsWindowAppearing();
    if (begins && !has_failed) begin(context, *row);
    bold_text(context, context.text(row->name_en, row->name_ja));
    dim_text(context, context.text(row->help_en, row->help_ja));
    ImGui::Separator();
    ReadValues read = this->read(*row);
    const std::string fault = !read.values ? read.sentence.in(context.language())
                              : has_failed ? context.state.last.sentence.in(context.language())
                                           : "";
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string& told = fault.empty() ? preview_.told().in(context.language()) : fault;
    const float lines = wrapped_size(told, ImGui::GetContentRegionAvail().x).y + style.ItemSpacing.y;
    const float below = ImGui::GetFrameHeightWithSpacing() + 2 * style.ItemSpacing.y + (told.empty() ? 0 : lines);
    if (begins) to_keys_ = 0;
    const std::optional<std::size_t> entered = draw_fields(context, *row, below);
    read = this->read(*row);  // with what was just written
    ImGui::Separator();
    if (!told.empty()) coloured_text(fault.empty() ? context.colours().dim : context.colours().warning, told.c_str());
    ImGui::BeginDisabled(!read.values);
    const bool pressed = ImGui::Button(context.text("Run", "実行"), {120 * context.scale, 0});
    ImGui::EndDisabled();
    draw_preview(context, *row, read);
    if (!read.values && entered) to_keys_ = lacking(row->parameters, texts_).value_or(*entered);
    if (!read.values || !(pressed || entered)) return;
    has_run_ = true;
    to_keys_ = 0;
    preview_.hand_over(context.session);
    context.run_from(AlgorithmCall{row, *read.values}, context.layout.open_panel);
  }

  void closed(PanelContext& context) override {
    preview_.end(context.document(), context.view, context.framing, context.shown);
  }
  bool leaves_view() const override { return true; }

  ImVec2 size() const override {
    const AlgorithmRow* const row = find_algorithm(algorithm_);
    if (!row) return {410, 420};
    if (height_ > 0) return {410, height_};
    float height = 190;
    for (const ParameterRow& parameter : row->parameters) height += shows_what_it_takes(parameter) ? 32.f : 60.f;
    return {410, height};
  }

 private:
  // The number of the field in which Enter was pressed. `below` is what stands behind them. Between what the algorithm
  // does and what runs it, which stay in sight.
  std::optional<std::size_t> draw_fields(PanelContext& context, const AlgorithmRow& row, float below) {
    std::optional<std::size_t> entered;
    const float top = ImGui::GetCursorPosY();
    rows_.begin("fields", std::max(1.f, ImGui::GetContentRegionAvail().y - below));
    if (ImGui::BeginTable("parameters", 2)) {
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 1.3f);
      ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 2.4f);
      for (std::size_t i = 0; i < row.parameters.size(); ++i) {
        const ParameterRow& parameter = row.parameters[i];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        rows_.row();
        ImGui::AlignTextToFramePadding();
        wrapped_text(context.text(parameter.name_en, parameter.name_ja));
        tip(context.text(parameter.help_en, parameter.help_ja));
        ImGui::TableNextColumn();
        if (to_keys_ == i) {
          ImGui::SetKeyboardFocusHere();
          to_keys_.reset();
        }
        if (draw_parameter_field(context, parameter, texts_[i], EnterAt::runs)) entered = i;
        tip(context.text(parameter.help_en, parameter.help_ja));
        if (const std::string hint = hint_of(context, parameter); !hint.empty()) dim_text(context, hint.c_str());
      }
      ImGui::EndTable();
    }
    rows_.end();
    // With room for a sentence of two lines, so that the height stays when one comes.
    const float least = 2 * ImGui::GetFrameHeightWithSpacing() + 2 * ImGui::GetTextLineHeightWithSpacing();
    fit_height(context, top + rows_.height() + std::max(below, least) + ImGui::GetStyle().WindowPadding.y);
    return entered;
  }

  // What is selected is what it is first asked for, where its row works on elements; what else fields begin with may
  // depend on the mesh.
  void begin(PanelContext& context, const AlgorithmRow& row) {
    has_run_ = false;
    if (algorithm_ != row.id) height_ = 0;
    algorithm_ = row.id;
    const auto takes_elements = [](const ParameterRow& p) { return p.kind == ParameterKind::elements; };
    selected_.clear();
    context.shown.end();  // what another one shows has no selection, and is another mesh
    if (std::any_of(row.parameters.begin(), row.parameters.end(), takes_elements))
      selected_ = context.selecting.selected_names();
    texts_.clear();
    for (const ParameterRow& parameter : row.parameters)
      texts_.push_back(parameter.is_worked_on && !selected_.empty() ? std::string(selection_word)
                                                                    : first_text(parameter, context.mesh()));
  }

  // What the fields say; the word for the selection stays a word, however much is selected.
  ReadValues read(const AlgorithmRow& row) const {
    const std::vector<std::string> word{std::string(selection_word)};
    return read_fields(row.parameters, texts_, &word);
  }

  void fit_height(PanelContext& context, float height_px) {
    const float height = std::ceil(height_px / context.scale);
    if (std::exchange(height_, height) != height) context.state.unsettle();
  }

  void draw_algorithms(PanelContext& context) {
    for (const AlgorithmRow& other : algorithm_table())
      if (link(context, context.text(other.name_en, other.name_ja))) context.run("values " + std::string(other.id));
  }

  // Whether what the fields say is shown in the view, and what it would come to.
  void draw_preview(PanelContext& context, const AlgorithmRow& row, const ReadValues& read) {
    const bool is_offered = preview_.is_offered(context.findings(), context.shown);
    bool none = false;
    ImGui::BeginDisabled(!is_offered);
    ImGui::SameLine();
    ImGui::Checkbox(is_costly_to_try(context.mesh())
                        ? context.text("Preview (up to 20,000 faces)", "プレビュー（20,000 面まで）")
                        : context.text("Preview", "プレビュー"),
                    is_offered ? &has_preview_ : &none);
    ImGui::EndDisabled();
    tip(context.text("Shows in the view what it would do, where that is quick: on meshes of at most 20,000 faces.",
                     "実行結果をビューに示します（20,000 面までの、すぐ終わるものだけ）。"),
        ImGuiHoveredFlags_AllowWhenDisabled);
    if (has_preview_ && read.values && is_offered)
      preview_.show(context.session, row, with_names(*read.values, selected_));
    else
      preview_.end(context.document(), context.view, context.framing, context.shown);
  }

  std::string algorithm_;  // its id
  WholeRows rows_;
  float height_ = 0;                    // that all of its fields take, at scale 1; 0 as long as it is not known
  bool has_run_ = false;                // with these values; where that failed, the reason stands beside them
  std::optional<std::size_t> to_keys_;  // the field that is to have the keyboard next
  std::vector<std::string> texts_;      // what stands in the fields of its parameters
  std::vector<std::string> selected_;   // the names of what was selected when it was opened
  AlgorithmPreview preview_;
  bool has_preview_ = true;  // wanted, where it is quick
};

}  // namespace

std::unique_ptr<Panel> make_values_panel() { return std::make_unique<ValuesPanel>(); }

}  // namespace ryosen
