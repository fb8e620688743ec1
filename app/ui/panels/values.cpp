// The values of an algorithm: one field per parameter, as its row describes it.
#include <utility>

#include "app/editor/commands.h"
#include "app/ui/panels.h"
#include "app/ui/parameter_field.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// One field per parameter of the algorithm that is asked for; without one, all of them to choose from.
class ValuesPanel : public Panel {
 public:
  void draw(PanelContext& context) override;
  ImVec2 size() const override { return {560, 160 + 88 * static_cast<float>(texts_.size())}; }

 private:
  // True when Enter was pressed in a field.
  bool draw_fields(PanelContext& context, const AlgorithmRow& row, bool begins);

  std::string algorithm_;           // its id
  bool has_run_ = false;            // with these values; where that failed, the reason stands beside them
  bool takes_keys_ = false;         // the first field is to have the keyboard, where this is asked again
  std::vector<std::string> texts_;  // what stands in the fields of its parameters
};

bool ValuesPanel::draw_fields(PanelContext& context, const AlgorithmRow& row, bool begins) {
  bool entered = false;
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const ParameterRow& parameter = row.parameters[i];
    ImGui::Dummy({0, 4 * context.scale});
    ImGui::TextUnformatted(context.text(parameter.name_en, parameter.name_ja));
    if (i == 0 && begins) ImGui::SetKeyboardFocusHere();
    entered = draw_parameter_field(context, parameter, texts_[i]) || entered;
    tip(context.text(parameter.help_en, parameter.help_ja));
    dim_text(context, described(parameter).in(context.language()).c_str());
  }
  return entered;
}

void ValuesPanel::draw(PanelContext& context) {
  const AlgorithmRow* const row = find_algorithm(context.session.asked_algorithm);
  if (!row) {
    for (const AlgorithmRow& other : algorithm_table())
      if (link(context, context.text(other.name_en, other.name_ja))) context.run("values " + std::string(other.id));
    return;
  }
  const bool has_failed = algorithm_ == row->id && has_run_ && context.state.last_kind != Outcome::Kind::done;
  const bool begins = algorithm_ != row->id || ImGui::IsWindowAppearing();
  if (begins && !has_failed) {
    has_run_ = false;
    algorithm_ = row->id;
    texts_.clear();
    for (const ParameterRow& parameter : row->parameters) texts_.emplace_back(parameter.initial);
  }
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(context.text(row->name_en, row->name_ja));
  dim_text(context, context.text(row->help_en, row->help_ja));
  const bool entered = draw_fields(context, *row, begins || std::exchange(takes_keys_, false));
  const ReadValues read = read_fields(row->parameters, texts_);
  ImGui::Dummy({0, 8 * context.scale});
  ImGui::BeginDisabled(!read.values);
  const bool pressed = ImGui::Button(context.text("Run", "実行"), {120 * context.scale, 0});
  ImGui::EndDisabled();
  if (!read.values) coloured_text(context.colours().warning, read.sentence.in(context.language()).c_str());
  if (has_failed) coloured_text(context.colours().warning, context.state.last_outcome.in(context.language()).c_str());
  ImGui::PopTextWrapPos();
  if (!read.values || !(pressed || entered)) return;
  has_run_ = takes_keys_ = true;
  context.run_from(line_of(*row, *read.values), context.session.open_panel);
}

}  // namespace

std::unique_ptr<Panel> make_values_panel() { return std::make_unique<ValuesPanel>(); }

}  // namespace ryosen
