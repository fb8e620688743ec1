#include <algorithm>
#include <iterator>

#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/shown.h"
#include "app/editor/textbook/exercises.h"
#include "app/editor/textbook/playing.h"
#include "app/ui/panels.h"
#include "app/ui/whole_rows.h"
#include "app/ui/widgets.h"
#include "ryosen/document/document.h"

namespace ryosen {

namespace {

void draw_cells(PanelContext& context, const std::vector<steps::RowChange>& cells) {
  const std::string none = context.text("none", "なし");
  list_of_rows(
      "cells", cells.size(), 9,
      [&](std::size_t i) {
        const steps::RowChange& cell = cells[i];
        const std::string is = cell.new_value.value_or(none);
        const std::string values = cell.old_value == cell.new_value ? is : cell.old_value.value_or(none) + " > " + is;
        const std::string label = cell.row + " " + cell.field;
        ImGui::PushID(static_cast<int>(i));
        const std::string shown = fitted(values, 0.6f * ImGui::GetContentRegionAvail().x);
        row(context, label.c_str(), shown.c_str(), cell.old_value != cell.new_value);
        tip(cell.table + " " + label + ": " + values);
        ImGui::PopID();
      },
      {}, row_pitch(context));
}

// Each role once, with its elements.
void draw_roles(PanelContext& context, const steps::Step& step) {
  std::vector<steps::Role> told;
  for (const steps::Mark& mark : step.marks) {
    if (std::find(told.begin(), told.end(), mark.role) != told.end()) continue;
    told.push_back(mark.role);
    std::vector<Element> elements;
    for (const steps::Mark& other : step.marks)
      if (other.role == mark.role && elements.size() < 12) elements.push_back(other.element);
    const steps::RoleRow& role = steps::row_of(mark.role);
    std::string names;
    for (const Element element : elements) names += (names.empty() ? "" : " ") + slot_name(element);
    labelled(context, context.text(role.en, role.ja), names, 9);
  }
}

// The table of the step's first cell as it stands, behind a header that is closed at first.
void draw_tables(PanelContext& context, StepsPlayer& player) {
  const std::string& first = player.step()->rows.front().table;
  if (!ImGui::CollapsingHeader(context.text("The whole table", "表全体"))) return;
  const steps::Tables::Rows& rows = player.tables().rows_of(first);
  dim_text(context, (first + ", " + std::to_string(rows.size())).c_str());
  auto at = rows.begin();
  std::size_t place = 0;
  list_of_rows(
      "table", rows.size(), 12,
      [&](std::size_t i) {
        std::advance(at, static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(place));
        place = i;
        std::string fields;
        for (const auto& [field, value] : at->second) fields += (fields.empty() ? "" : ", ") + field + " " + value;
        const float room = 0.75f * ImGui::GetContentRegionAvail().x;
        row(context, at->first.c_str(), fitted(fields, room).c_str(), false);
        tip(at->first + ": " + fields);
      },
      {}, row_pitch(context));
}

// The number that grows with the steps, and where in it the position is.
void draw_curve(PanelContext& context, const StepsPlayer& player) {
  const std::optional<steps::Curve> curve = player.curve();
  if (!curve || curve->values.empty()) return;
  const std::size_t position = std::min(player.position(), curve->values.size());
  const std::uint32_t now = position == 0 ? 0 : curve->values[position - 1];
  labelled(context, curve->name.in(context.language()).c_str(), std::to_string(now), 9);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 64 * context.scale), from = ImGui::GetCursorScreenPos();
  const float most = static_cast<float>(curve->values.back());
  // As many values as there are pixels, from 0 steps on.
  const std::size_t shown = std::min(curve->values.size() + 1, static_cast<std::size_t>(std::max(2.0f, size.x)));
  const auto value_at = [&](std::size_t pixel) {
    const std::size_t step = pixel * curve->values.size() / (shown - 1);
    return step == 0 ? 0.0f : static_cast<float>(curve->values[step - 1]);
  };
  std::vector<float> values(shown);
  for (std::size_t i = 0; i < shown; ++i) values[i] = value_at(i);
  ImGui::PlotLines("##curve", values.data(), static_cast<int>(shown), 0, nullptr, 0, most, size);
  const float x = from.x + size.x * static_cast<float>(position) / static_cast<float>(curve->values.size());
  ImGui::GetWindowDrawList()->AddLine({x, from.y}, {x, from.y + size.y}, ImGui::GetColorU32(ImGuiCol_PlotHistogram), 2);
}

// What is played step by step: what there is to play, the way through it, and what the step does.
class StepsPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    const std::shared_ptr<StepsPlayer> player = steps_player(context.shown);
    if (!player) return draw_choice(context);
    const std::string at = std::to_string(player->position()) + " / " + std::to_string(player->size());
    const std::string name = player->name().in(context.language());
    if (row(context, name.c_str(), at.c_str(), true)) context.run("steps close");
    tip(name + "\n" +
        context.text("A click ends it, and shows what else there is to play.",
                     "クリックすると終わり、ほかに再生できるものを表示します。"));
    if (!context.shown.fits())
      coloured_text(context.colours().warning,
                    context.text("The mesh has changed since; play it again.",
                                 "再生を始めた後にメッシュが変わりました。再生し直してください。"));
    draw_ways(context, *player);
    if (const Text remark = player->remark(); !remark.en.empty())
      dim_text(context, remark.in(context.language()).c_str());
    draw_curve(context, *player);
    draw_step(context, *player);
  }

 private:
  struct Offered {
    std::string label, call;  // no call: it stands above others
    const char* help;
  };

  // Scripts by name, the rest as it fits the mesh and the selection.
  std::vector<Offered> offers(PanelContext& context) {
    std::vector<Offered> all;
    for (const steps::StepsRow& steps_row : steps::all_steps()) {
      const char* const help = context.text(steps_row.help_en, steps_row.help_ja);
      const auto add = [&](std::span<const std::string> arguments) {
        std::vector<std::string> words{std::string(steps_row.id)};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::string call = words[0];
        for (const std::string& argument : arguments) call += " " + argument;
        all.push_back({capitalized(name_of_played(words).in(context.language())), std::move(call), help});
      };
      const auto add_script = [&](std::string_view name) { add(std::vector{std::string(name)}); };
      all.push_back({capitalized(context.text(steps_row.en, steps_row.ja)), "", help});
      if (steps_row.plays_script) {
        for (const std::span<const ExerciseScript> scripts : {exercise_scripts(), figure_scripts()})
          for (const ExerciseScript& script : scripts) add_script(script.id);
        if (!context.document().history().empty()) add_script(history_word);
        continue;
      }
      const auto row_number = static_cast<std::size_t>(&steps_row - steps::all_steps().data());
      for (const std::vector<std::string>& arguments : choices(context.document(), context.selecting)[row_number])
        add(arguments);
      if (choices(context.document(), context.selecting)[row_number].empty())
        all.push_back({context.text("  not on this mesh", "  このメッシュでは再生できません"), "", help});
    }
    return all;
  }

  // In a list of its own height, so that the panels below stay in sight.
  void draw_choice(PanelContext& context) {
    const std::vector<Offered> all = offers(context);
    constexpr float most_lines = 14;
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float lines = static_cast<float>(all.size()) * line;  // until it is seen, and known which of them are wrapped
    offered_.begin("choice", std::min(offered_.height() > 0 ? offered_.height() : lines, most_lines * line));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Offered& offered = all[i];
      const float width = ImGui::GetContentRegionAvail().x;
      offered_.row_of_text();
      if (offered.call.empty()) {
        dim_text(context, offered.label.c_str());
        continue;
      }
      ImGui::PushID(static_cast<int>(i));
      if (wrapped_row(context, offered.label, false, width)) context.run("steps " + offered.call);
      tip(std::string(offered.help) + "\nsteps " + offered.call);
      ImGui::PopID();
    }
    offered_.end();
  }

  // What the rows of the table offer, asked once for a revision and selection.
  const std::vector<steps::Choices>& choices(const Document& document, const Selecting& selecting) {
    if (!choices_.empty() && serial_ == document.serial() && revision_ == document.revision() &&
        selection_ == selecting.selection.stamp())
      return choices_;
    serial_ = document.serial();
    revision_ = document.revision();
    selection_ = selecting.selection.stamp();
    choices_.clear();
    for (const steps::StepsRow& row : steps::all_steps())
      choices_.push_back(row.choices(document.mesh(), selecting.selection));
    return choices_;
  }

  void draw_ways(PanelContext& context, const StepsPlayer& player) {
    const bool at_start = player.position() == 0, at_end = player.position() == player.size();
    struct Button {
      const char* label;
      const char* line;
      const char *help_en, *help_ja;
      bool is_off;
    };
    const Button buttons[] = {
        {"|<", "steps first", "To the state before the first step.", "最初の手順の前に戻ります。", at_start},
        {"<", "steps back", "One step back.", "一手戻ります。", at_start},
        {player.is_running ? "||" : context.text("Play", "再生"), "steps play", "Goes forward by itself, or stops.",
         "自動で進みます。もう一度押すと止まります。", false},
        {">", "steps forward", "One step forward.", "一手進みます。", at_end},
        {">|", "steps last", "To the end.", "最後まで進みます。", at_end},
    };
    const float gap = 4 * context.scale, width = (ImGui::GetContentRegionAvail().x - 4 * gap) / 5;
    for (const Button& button : buttons) {
      if (&button != buttons) ImGui::SameLine(0, gap);
      ImGui::PushID(button.line);
      ImGui::BeginDisabled(button.is_off);
      if (ImGui::Button(button.label, {width, 0})) context.run(button.line);
      ImGui::EndDisabled();
      const std::string chord = chord_of(context.preferences, button.line);
      tip(std::string(context.text(button.help_en, button.help_ja)) + (chord.empty() ? "" : " (" + chord + ")"),
          ImGuiHoveredFlags_AllowWhenDisabled);
      ImGui::PopID();
    }
  }

  void draw_step(PanelContext& context, StepsPlayer& player) {
    const steps::Step* const step = player.step();
    if (!step) return dim_text(context, context.text("Before the first step.", "最初の手順の前です。"));
    wrapped_text(step->caption.in(context.language()).c_str());
    if (step->delta)
      coloured_text(context.colours().accent, steps::text_of(*step->delta).in(context.language()).c_str());
    draw_cells(context, step->rows);
    if (!step->rows.empty() && player.has_tables()) draw_tables(context, player);
    draw_roles(context, *step);
    if (!step->source) return;
    std::string source = std::string(context.text("Text ", "テキスト ")) + std::string(step->source->text) + ", " +
                         context.text(step->source->listing_en, step->source->listing_ja);
    if (step->source->line > 0)
      source += context.language() == Language::japanese ? " " + std::to_string(step->source->line) + " 行目"
                                                         : ", line " + std::to_string(step->source->line);
    dim_text(context, source.c_str());
  }

  WholeRows offered_;
  std::vector<steps::Choices> choices_;
  std::uint64_t serial_ = 0, revision_ = 0;  // of what they were asked
  std::uint64_t selection_ = 0;              // by its stamp
};

}  // namespace

std::unique_ptr<Panel> make_steps_panel() { return std::make_unique<StepsPanel>(); }

}  // namespace ryosen
