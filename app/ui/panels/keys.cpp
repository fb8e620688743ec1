// The keys, each of which can be bound to another, and the mouse.
#include "app/editor/preferences/keys.h"

#include <algorithm>

#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/preferences/preferences.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

#include <imgui_stdlib.h>  // needs imgui.h before it

namespace ryosen {

namespace {

void pair_row(PanelContext& context, const char* chord, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(context.colours().accent, chord);
  ImGui::TableNextColumn();
  wrapped_text(help);
}

const InputPreset& preset_of(const PanelContext& context) { return input_presets()[context.preferences.input_preset]; }

void draw_mouse(PanelContext& context, const std::vector<MouseRow>& rows) {
  for (const MouseRow& row : rows)
    pair_row(context, row.input.in(context.language()).c_str(), row.does.in(context.language()).c_str());
}

class KeysPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    if (ImGui::IsWindowAppearing()) is_asking_ = context.state.asks_for_key = false;
    if (is_asking_ && !context.state.asks_for_key && wanted_.empty()) take(context, context.state.asked_key);
    draw_presets(context);
    draw_question(context);
    draw_search(context);
    begin_rows_within("rows", ImGui::GetContentRegionAvail().y);
    draw_rows(context);
    end_rows();
  }

  ImVec2 size() const override { return {800, 540}; }

 private:
  void draw_search(PanelContext& context) {
    if (ImGui::IsWindowAppearing()) {
      typed_.clear();
      ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", context.text(UiText::search_hint), &typed_);
  }

  void draw_presets(PanelContext& context) {
    ImGui::SetNextItemWidth(260 * context.scale);
    if (ImGui::BeginCombo("##preset", context.text(preset_of(context).name_en, preset_of(context).name_ja))) {
      for (const InputPreset& preset : input_presets())
        if (ImGui::Selectable(context.text(preset.name_en, preset.name_ja), &preset == &preset_of(context)))
          context.run("preset " + std::string(preset.id));
      ImGui::EndCombo();
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(context.preferences.bindings.empty());
    if (ImGui::Button(context.text("Reset keys", "キーを戻す"))) context.run("bind all initial");
    ImGui::EndDisabled();
    tip(context.text("Every key does again what the preset says.", "すべてのキーを最初の割り当てに戻します。"),
        ImGuiHoveredFlags_AllowWhenDisabled);
  }

  // The keys, and the mouse beside them.
  void draw_rows(PanelContext& context) {
    const std::vector<KeyRow> keys = sought_keys(context);
    std::vector<MouseRow> mouse = mouse_table(preset_of(context));
    std::erase_if(mouse, [&](const MouseRow& row) { return !is_sought(row.input.en + " " + row.input.ja, row.does); });
    if (keys.empty() && mouse.empty()) return dim_text(context, context.text(UiText::nothing_found));
    const float gap = 16 * context.scale, half = (ImGui::GetContentRegionAvail().x - gap) / 2;
    const auto part = [&](const char* id, UiText title, float help_share, auto fill) {
      ImGui::BeginGroup();
      dim_text(context, context.text(title));
      if (ImGui::BeginTable(id, 2, 0, {half, 0})) {
        ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 1);
        ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch, help_share);
        fill();
        ImGui::EndTable();
      }
      ImGui::EndGroup();
    };
    if (!keys.empty()) part("keys", UiText::key, 2.4f, [&] { draw_keys(context, keys); });
    if (!keys.empty() && !mouse.empty()) ImGui::SameLine(0, gap);
    if (!mouse.empty()) part("mouse", UiText::mouse, 1, [&] { draw_mouse(context, mouse); });
  }

  // A press on a key asks for another one.
  void draw_keys(PanelContext& context, const std::vector<KeyRow>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const KeyRow& row = rows[i];
      ImGui::PushID(static_cast<int>(i));
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      const bool is_own = std::any_of(context.preferences.bindings.begin(), context.preferences.bindings.end(),
                                      [&](const KeyBinding& binding) { return binding.chord == row.chord; });
      const ImVec4& colour = row.chord.empty() ? context.colours().warning : context.colours().accent;
      ImGui::PushStyleColor(ImGuiCol_Text, colour);
      const std::string chord = row.chord.empty() ? context.text("no key", "なし") : row.chord + (is_own ? " *" : "");
      const bool is_pressed = ImGui::Selectable(chord.c_str(), is_asking_ && asked_.command == row.command);
      ImGui::PopStyleColor();
      tip(context.text("Click, then press another key for this.", "クリックしてから、別のキーを押すと変わります。"));
      if (is_pressed && row.chord != "Escape") {
        asked_ = row;
        is_asking_ = context.state.asks_for_key = true;
        wanted_.clear();
      }
      ImGui::TableNextColumn();
      wrapped_text(help_of_key(row).in(context.language()).c_str());
      ImGui::PopID();
    }
  }

  bool is_sought(std::string_view input, const Text& does) const {
    return has_words(folded(std::string(input) + " " + does.en + " " + does.ja), folded(typed_));
  }

  std::vector<KeyRow> sought_keys(const PanelContext& context) const {
    std::vector<KeyRow> rows = rows_without_key(preset_of(context), context.preferences.bindings);
    for (KeyRow& row : key_table(preset_of(context), context.preferences.bindings)) rows.push_back(std::move(row));
    std::erase_if(rows, [&](const KeyRow& row) { return !is_sought(row.chord, help_of_key(row)); });
    return rows;
  }

  void draw_question(PanelContext& context) {
    const std::string what = help_of_key(asked_).in(context.language());
    if (!is_asking_)
      return dim_text(context, context.text("Click a key to change it; * is your own.",
                                            "キーをクリックすると変更できます。* は変更したキーです。"));
    if (context.state.asks_for_key)
      return coloured_text(context.colours().accent,
                           (context.text("Press the new key for: ", "新しいキーを押してください：") + what).c_str());
    const auto other = conflict_of(context.preferences, wanted_, asked_.command);
    if (!other) return;
    const std::string in_use = help_of_key(*other).in(context.language());
    coloured_text(context.colours().warning,
                  context.language() == Language::japanese
                      ? (wanted_ + " は「" + in_use + "」に使われています。「" + what + "」に割り当てますか。").c_str()
                      : (wanted_ + " does '" + in_use + "' already. Is it to do '" + what + "'?").c_str());
    ImGui::BeginDisabled(asked_.chord.empty());
    const bool swaps = ImGui::Button(context.text("Swap the two", "入れ替える"));
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool takes =
        ImGui::Button(context.text("Take it; the other has no key then", "奪う（相手のキーはなくなる）"));
    ImGui::SameLine();
    const bool leaves = ImGui::Button(context.text(UiText::cancel));
    if (swaps || takes) rebind(context, swaps);
    if (leaves) is_asking_ = false;
  }

  void take(PanelContext& context, const std::string& chord) {
    is_asking_ = chord != "Escape" && chord != asked_.chord;
    if (!is_asking_) return;
    wanted_ = chord;
    if (!conflict_of(context.preferences, chord, asked_.command)) rebind(context, false);
  }

  // The other command gets the key that this had, or none.
  void rebind(PanelContext& context, bool swaps) {
    const auto other = conflict_of(context.preferences, wanted_, asked_.command);
    if (!asked_.chord.empty()) context.run("bind " + asked_.chord + " none");
    if (swaps && other && !asked_.chord.empty()) context.run("bind " + asked_.chord + " " + other->command);
    context.run("bind " + wanted_ + " " + asked_.command);
    is_asking_ = false;
  }

  std::string typed_;   // the words that rows are sought by
  KeyRow asked_;        // which is to get another key, while it is asked for; its chord may be empty
  std::string wanted_;  // the key that was pressed although another command has it
  bool is_asking_ = false;
};

}  // namespace

std::unique_ptr<Panel> make_keys_panel() { return std::make_unique<KeysPanel>(); }

}  // namespace ryosen
