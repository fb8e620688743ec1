// The keys, each of which can be bound to another, and the mouse.
#include "app/editor/keys.h"

#include <algorithm>

#include "app/editor/preferences.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

class KeysPanel : public Panel {
 public:
  void draw(PanelContext& context) override;
  ImVec2 size() const override { return {800, 540}; }

 private:
  void draw_presets(PanelContext& context);
  void draw_keys(PanelContext& context);
  void draw_question(PanelContext& context);
  void take(PanelContext& context, const std::string& chord);
  void rebind(PanelContext& context, bool swaps);

  KeyRow asked_;        // which is to get another key, while it is asked for; its chord may be empty
  std::string wanted_;  // the key that was pressed although another command has it
  bool is_asking_ = false;
};

void pair_row(PanelContext& context, const char* chord, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(context.colours().accent, chord);
  ImGui::TableNextColumn();
  wrapped_text(help);
}

const InputPreset& preset_of(const PanelContext& context) { return input_presets()[context.session.input_preset]; }

void draw_mouse(PanelContext& context) {
  for (const MouseRow& row : mouse_table(preset_of(context)))
    pair_row(context, row.input.in(context.language()).c_str(), row.does.in(context.language()).c_str());
}

void KeysPanel::draw_presets(PanelContext& context) {
  ImGui::SetNextItemWidth(260 * context.scale);
  if (ImGui::BeginCombo("##preset", context.text(preset_of(context).name_en, preset_of(context).name_ja))) {
    for (const InputPreset& preset : input_presets())
      if (ImGui::Selectable(context.text(preset.name_en, preset.name_ja), &preset == &preset_of(context)))
        context.run("preset " + std::string(preset.id));
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(context.session.bindings.empty());
  if (ImGui::Button(context.text("Reset keys", "キーを戻す"))) context.run("bind all initial");
  ImGui::EndDisabled();
  tip(context.text("Every key does again what the preset says.", "すべてのキーを最初の割り当てに戻します。"),
      ImGuiHoveredFlags_AllowWhenDisabled);
}

// A press on a key asks for another one.
void KeysPanel::draw_keys(PanelContext& context) {
  std::vector<KeyRow> rows = key_table(preset_of(context), context.session.bindings);
  const std::vector<KeyRow> without = rows_without_key(preset_of(context), context.session.bindings);
  rows.insert(rows.begin(), without.begin(), without.end());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const KeyRow& row = rows[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const bool is_own = std::any_of(context.session.bindings.begin(), context.session.bindings.end(),
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

void KeysPanel::take(PanelContext& context, const std::string& chord) {
  is_asking_ = chord != "Escape" && chord != asked_.chord;
  if (!is_asking_) return;
  wanted_ = chord;
  if (!conflict_of(context.session, chord, asked_.command)) rebind(context, false);
}

// The other command gets the key that this had, or none.
void KeysPanel::rebind(PanelContext& context, bool swaps) {
  const auto other = conflict_of(context.session, wanted_, asked_.command);
  if (!asked_.chord.empty()) context.run("bind " + asked_.chord + " none");
  if (swaps && other && !asked_.chord.empty()) context.run("bind " + asked_.chord + " " + other->command);
  context.run("bind " + wanted_ + " " + asked_.command);
  is_asking_ = false;
}

void KeysPanel::draw_question(PanelContext& context) {
  const std::string what = help_of_key(asked_).in(context.language());
  if (!is_asking_)
    return dim_text(context, context.text("Click a key to change it; * is your own.",
                                          "キーをクリックすると変更できます。* は変更したキーです。"));
  if (context.state.asks_for_key)
    return coloured_text(context.colours().accent,
                         (context.text("Press the new key for: ", "新しいキーを押してください：") + what).c_str());
  const auto other = conflict_of(context.session, wanted_, asked_.command);
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
  const bool takes = ImGui::Button(context.text("Take it; the other has no key then", "奪う（相手のキーはなくなる）"));
  ImGui::SameLine();
  const bool leaves = ImGui::Button(context.text(UiText::cancel));
  if (swaps || takes) rebind(context, swaps);
  if (leaves) is_asking_ = false;
}

void KeysPanel::draw(PanelContext& context) {
  if (ImGui::IsWindowAppearing()) is_asking_ = context.state.asks_for_key = false;
  if (is_asking_ && !context.state.asks_for_key && wanted_.empty()) take(context, context.state.asked_key);
  draw_presets(context);
  draw_question(context);
  const auto table = [&](const char* id, float help_share, auto fill) {
    if (!ImGui::BeginTable(id, 2)) return;
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 1);
    ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch, help_share);
    fill();
    ImGui::EndTable();
  };
  const float height = ImGui::GetContentRegionAvail().y;
  const float half = ImGui::GetContentRegionAvail().x / 2 - 8 * context.scale;
  begin_rows_within("keys", height, half);
  dim_text(context, context.text(UiText::key));
  table("keys", 2.4f, [&] { draw_keys(context); });
  end_rows();
  ImGui::SameLine(0, 16 * context.scale);
  begin_rows_within("mouse", height, half);
  dim_text(context, context.text(UiText::mouse));
  table("mouse", 1, [&] { draw_mouse(context); });
  end_rows();
}

}  // namespace

std::unique_ptr<Panel> make_keys_panel() { return std::make_unique<KeysPanel>(); }

}  // namespace ryosen
