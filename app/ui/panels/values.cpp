// The values of an algorithm or an operator: one field per parameter, as its row describes it.
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
#include "app/editor/shown/asked_values.h"
#include "app/editor/shown/shown.h"
#include "app/editor/shown/values_preview.h"
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

// In few words: the elements of a selection are not listed.
std::string text_of_failure(const PanelContext& context) {
  const LastOutcome& last = context.state.last;
  return (last.shorter.empty() ? last.sentence : last.shorter.back()).in(context.language());
}

// One field per parameter of what is asked for; without that, all algorithms to choose from.
class ValuesPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    const Layout& layout = context.layout;
    const bool is_new = algorithm_ != layout.asked_algorithm || operator_ != layout.asked_operator;
    const bool has_failed = !is_new && has_run_ && context.state.last.kind != Outcome::Kind::done;
    const bool begins = is_new || ImGui::IsWindowAppearing();
    if (begins && !has_failed) begin(context, is_new);
    if (!asked_) return draw_algorithms(context);
    if (context.shown.by() == ShownBy::document)
      asked_->look_at_selection(context.document(), context.findings(), context.selecting);
    const RowWords& words = asked_->words();
    bold_text(context, context.text(words.name_en, words.name_ja));
    dim_text(context, context.text(words.help_en, words.help_ja));
    ImGui::Separator();
    std::optional<Text> wrong = asked_->fault();
    const std::string fault = wrong ? wrong->in(context.language()) : has_failed ? text_of_failure(context) : "";
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string& told = fault.empty() ? preview_.told().in(context.language()) : fault;
    const float lines = wrapped_size(told, ImGui::GetContentRegionAvail().x).y + style.ItemSpacing.y;
    const float below = ImGui::GetFrameHeightWithSpacing() + 2 * style.ItemSpacing.y + (told.empty() ? 0 : lines);
    if (begins) to_keys_ = 0;
    const std::optional<std::size_t> entered = draw_fields(context, below);
    wrong = asked_->fault();  // with what was just written
    ImGui::Separator();
    if (!told.empty()) coloured_text(fault.empty() ? context.colours().dim : context.colours().warning, told.c_str());
    ImGui::BeginDisabled(wrong.has_value());
    const bool pressed = ImGui::Button(context.text("Run", "実行"), {120 * context.scale, 0});
    ImGui::EndDisabled();
    draw_preview(context, !wrong);
    if (wrong && entered) to_keys_ = asked_->lacking().value_or(*entered);
    if (wrong || !(pressed || entered)) return;
    has_run_ = true;
    to_keys_ = 0;
    preview_.hand_over(context.session);
    context.run_from(asked_->command(), context.layout.open_panel);
  }

  void closed(PanelContext& context) override {
    preview_.end(context.document(), context.view, context.framing, context.shown);
  }
  bool leaves_view() const override { return true; }

  ImVec2 size() const override {
    if (!asked_) return {410, 420};
    if (height_ > 0) return {410, height_};
    float height = 190;
    for (const ValueField& field : asked_->fields())
      if (field.is_shown) height += shows_what_it_takes(field.row) ? 32.f : 60.f;
    return {410, height};
  }

 private:
  // The number of the field in which Enter was pressed. `below` is the height of what is drawn behind them. They lie
  // between what it does and what runs it, which stay in sight.
  std::optional<std::size_t> draw_fields(PanelContext& context, float below) {
    std::optional<std::size_t> entered;
    const float top = ImGui::GetCursorPosY();
    rows_.begin("fields", std::max(1.f, ImGui::GetContentRegionAvail().y - below));
    if (ImGui::BeginTable("parameters", 2)) {
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 1.3f);
      ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 2.4f);
      std::vector<ValueField>& fields = asked_->fields();
      for (std::size_t i = 0; i < fields.size(); ++i)
        if (fields[i].is_shown && draw_field(context, fields[i], to_keys_ == i)) entered = i;
      ImGui::EndTable();
    }
    asked_->follow();
    rows_.end();
    // With room for a sentence of two lines, so that the height stays when one comes.
    const float least = 2 * ImGui::GetFrameHeightWithSpacing() + 2 * ImGui::GetTextLineHeightWithSpacing();
    fit_height(context, top + rows_.height() + std::max(below, least) + ImGui::GetStyle().WindowPadding.y);
    return entered;
  }

  // Whether Enter was pressed in it.
  bool draw_field(PanelContext& context, ValueField& field, bool has_keys) {
    const ParameterRow& row = field.row;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    rows_.row();
    ImGui::AlignTextToFramePadding();
    wrapped_text(context.text(row.name_en, row.name_ja));
    tip(context.text(row.help_en, row.help_ja));
    ImGui::TableNextColumn();
    if (has_keys) {
      ImGui::SetKeyboardFocusHere();
      to_keys_.reset();
    }
    const bool entered = draw_parameter_field(context, row, field.text, EnterAt::runs);
    tip(context.text(row.help_en, row.help_ja));
    if (const std::string hint = hint_of(context, row); !hint.empty()) dim_text(context, hint.c_str());
    return entered;
  }

  // The first values may depend on the mesh and on what is selected.
  void begin(PanelContext& context, bool is_new) {
    const Layout& layout = context.layout;
    has_run_ = false;
    if (is_new) height_ = 0;
    algorithm_ = layout.asked_algorithm;
    operator_ = layout.asked_operator;
    const AlgorithmRow* const row = find_algorithm(algorithm_);
    const OpInfo* const op = find_op(operator_);
    asked_.reset();
    if (!row && !op) return;
    context.shown.end();  // what another one shows has no selection, and is another mesh
    asked_ = op ? ask_values(*op, context.document(), context.findings(), context.selecting)
                : ask_values(*row, context.mesh(), context.selecting);
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
  void draw_preview(PanelContext& context, bool is_complete) {
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
    if (has_preview_ && is_complete && is_offered)
      preview_.show(context.session, asked_->trial());
    else
      preview_.end(context.document(), context.view, context.framing, context.shown);
  }

  std::string algorithm_, operator_;  // the id of the one that is asked for; both empty for none
  std::unique_ptr<AskedValues> asked_;
  WholeRows rows_;
  float height_ = 0;                    // that all of its fields take, at scale 1; 0 as long as it is not known
  bool has_run_ = false;                // with these values; where that failed, the reason is said beside them
  std::optional<std::size_t> to_keys_;  // the field that is to have the keyboard next
  ValuesPreview preview_;
  bool has_preview_ = true;  // wanted, where it is quick
};

}  // namespace

std::unique_ptr<Panel> make_values_panel() { return std::make_unique<ValuesPanel>(); }

}  // namespace ryosen
