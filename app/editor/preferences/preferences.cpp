#include "app/editor/preferences/preferences.h"

#include <algorithm>

#include "app/editor/commands/text/script.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/preferences/view_switches.h"
#include "ryosen/base/number_text.h"

namespace ryosen {

namespace {

PreferenceRow row_of_switch(const ViewSwitch& row) {
  std::vector<Choice> choices;
  for (const SwitchValue& value : row.values) choices.push_back({value.id, value.name_en, value.name_ja});
  return {{.id = row.id,
           .kind = ParameterKind::choice,
           .name_en = row.preference_en,
           .name_ja = row.preference_ja,
           .help_en = row.help_en,
           .help_ja = row.help_ja,
           .initial = choices[row.first_in_window].id,
           .choices = choices},
          [row](const Session& session) { return std::string(row.values[row.value(session)].id); },
          [row](Session& session, const ParameterValue& value) {
            row.set(session, static_cast<std::size_t>(value.number));
          }};
}

const std::vector<PreferenceRow>& own_rows() {
  static const std::vector<PreferenceRow> rows{
      {{.id = "language",
        .kind = ParameterKind::choice,
        .name_en = "Language",
        .name_ja = "言語",
        .help_en = "of the window",
        .help_ja = "画面の言語",
        .initial = "en",
        .choices = {{"en", "English", "English"}, {"ja", "日本語", "日本語"}}},
       [](const Preferences& preferences) {
         return std::string(preferences.language == Language::japanese ? "ja" : "en");
       },
       [](Preferences& preferences, const ParameterValue& v) {
         preferences.language = v.number > 0 ? Language::japanese : Language::english;
       }},
      {{.id = "scale",
        .kind = ParameterKind::number,
        .name_en = "Scale",
        .name_ja = "拡大率",
        .help_en = "of the whole window, times that of the display",
        .help_ja = "画面全体の拡大率（ディスプレイの拡大率に掛ける）",
        .initial = "1",
        .smallest = 0.5,
        .largest = 3},
       [](const Preferences& preferences) { return format_double(preferences.ui_scale); },
       [](Preferences& preferences, const ParameterValue& v) { preferences.ui_scale = v.number; }},
      {{.id = "font_size",
        .kind = ParameterKind::count,
        .name_en = "Font size",
        .name_ja = "文字の大きさ",
        .help_en = "of letters alone, at scale 1",
        .help_ja = "文字だけの大きさ（等倍のとき）",
        .initial = "15",
        .smallest = 10,
        .largest = 32,
        .unit_en = "pixels",
        .unit_ja = "画素"},
       [](const Preferences& preferences) { return std::to_string(preferences.font_size_px); },
       [](Preferences& preferences, const ParameterValue& v) {
         preferences.font_size_px = static_cast<int>(v.number);
       }},
      {{.id = "crease_angle",
        .kind = ParameterKind::number,
        .name_en = "Crease angle",
        .name_ja = "折り目の角度",
        .help_en = "edges that bend by more stay sharp in smooth shading",
        .help_ja = "これより大きく曲がる稜線は滑らかな陰影でも鋭く残る",
        .initial = "30",
        .smallest = 0,
        .largest = 180,
        .unit_en = "degrees",
        .unit_ja = "度"},
       [](const Preferences& preferences) { return format_double(preferences.crease_deg); },
       [](Preferences& preferences, const ParameterValue& v) { preferences.crease_deg = v.number; }},
      {{.id = "samples",
        .kind = ParameterKind::count,
        .name_en = "Samples",
        .name_ja = "サンプル数",
        .help_en = "smooths the view by so many rendered pixels a side of each; more take longer",
        .help_ja = "一画素に縦横それぞれ描く点の数（多いほど滑らかで遅い）",
        .initial = "1",
        .smallest = 1,
        .largest = 4},
       [](const Preferences& preferences) { return std::to_string(preferences.samples); },
       [](Preferences& preferences, const ParameterValue& v) { preferences.samples = static_cast<int>(v.number); }},
  };
  return rows;
}

// `initial` stands for its value.
std::string_view meant(const PreferenceRow& row, std::string_view value) {
  return value == "initial" ? row.field.initial : value;
}

Text no_such_preference(std::string_view id) {
  std::vector<std::string> known;
  for (const PreferenceRow& row : preference_table()) known.emplace_back(row.field.id);
  const std::string wrong(id);
  return Text{"there is no preference '" + wrong + "'", "設定「" + wrong + "」はありません"} +
         did_you_mean(wrong, known);
}

}  // namespace

std::vector<PreferenceRow> preference_table() {
  std::vector<PreferenceRow> rows;
  for (const ViewSwitch& row : view_switches())
    if (!row.preference_en.empty()) rows.push_back(row_of_switch(row));
  rows.insert(rows.end(), own_rows().begin(), own_rows().end());
  return rows;
}

std::optional<PreferenceRow> find_preference(std::string_view id) {
  for (PreferenceRow& row : preference_table())
    if (row.field.id == id) return std::move(row);
  return std::nullopt;
}

std::optional<Text> fault_of_preference(std::string_view id, std::string_view value) {
  const auto row = find_preference(id);
  if (!row) return no_such_preference(id);
  return ParameterValues(std::span(&row->field, 1)).set(id, meant(*row, value), id);
}

std::optional<Text> prefer(Session& session, std::string_view id, std::string_view value) {
  const auto row = find_preference(id);
  if (!row) return no_such_preference(id);
  ParameterValues values(std::span(&row->field, 1));
  if (auto fault = values.set(id, meant(*row, value), id)) return fault;
  row->set(session, *values.at(0));
  return std::nullopt;
}

void bind(Preferences& preferences, const std::string& chord, BindTo to, const std::string& command) {
  std::erase_if(preferences.bindings, [&](const KeyBinding& binding) { return binding.chord == chord; });
  const auto usual = find_key(chord, input_presets()[preferences.input_preset]);
  const bool is_usual = usual ? usual->command == command : command.empty();
  if (to == BindTo::command && !is_usual) preferences.bindings.push_back({chord, command});
}

std::optional<KeyRow> conflict_of(const Preferences& preferences, std::string_view chord, std::string_view command) {
  auto row = find_key(chord, input_presets()[preferences.input_preset], preferences.bindings);
  return row && row->command != command ? std::move(row) : std::nullopt;
}

std::string line_of(const KeyBinding& binding) {
  return "bind " + binding.chord + " " + (binding.command.empty() ? "none" : binding.command);
}

}  // namespace ryosen
