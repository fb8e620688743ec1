// The commands of the user interface, of the preferences and of the user's own keys.

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/preferences/preferences.h"
#include "app/editor/session/frontend.h"
#include "app/editor/shown/asked_values.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/base/rows.h"
#include "ryosen/ops/all.h"

namespace ryosen {

namespace {

Outcome no_such_panel(const std::string& id) {
  const Text hint = did_you_mean(id, ids_of_rows(panel_list())),
             all{"; known: " + panel_ids(), "。あるのは " + panel_ids()};
  return usage_error(Text{"there is no panel '" + id + "'", "パネル「" + id + "」はありません"} +
                     (hint.en.empty() ? all : hint));
}

// What the command does with a panel; some only with those of the columns.
struct PanelAct {
  std::string_view id;
  bool of_columns;
  void (*act)(Layout& layout, const PanelRow& row);
};
constexpr PanelAct panel_acts[] = {
    {"on", false, [](Layout& layout, const PanelRow& row) { layout.show(row, true); }},
    {"off", false, [](Layout& layout, const PanelRow& row) { layout.show(row, false); }},
    {"fold", true, [](Layout& layout, const PanelRow& row) { layout.folded.emplace(row.id); }},
    {"unfold", true, [](Layout& layout, const PanelRow& row) { layout.folded.erase(std::string(row.id)); }},
    {"left", true, [](Layout& layout, const PanelRow& row) { layout.put(row, PanelPlace::left); }},
    {"right", true, [](Layout& layout, const PanelRow& row) { layout.put(row, PanelPlace::right); }},
    {"flyout", true,
     [](Layout& layout, const PanelRow& row) {
       layout.show(row, true);
       layout.flyout = row.id;
     }},
};

}  // namespace

Outcome run_panel(Layout& layout, Words arguments, std::string_view) {
  if (arguments.empty() || arguments.size() > 2) return wrong_arguments("panel");
  const std::string id(arguments[0]);
  if (id == "none" && arguments.size() > 1)
    return usage_error("panel none closes what lies over the view; it takes no further word",
                       "panel none は画面に重なるものを閉じます。後ろに言葉は付けられません");
  if (id == "none") {
    layout.open_panel.clear();
    layout.flyout.clear();
    return {};
  }
  const std::string_view word = arguments.size() == 1 ? "on" : arguments[1];
  const PanelAct* const act = find_row(panel_acts, word);
  if (!act) return wrong_arguments("panel");
  const PanelRow* const row = find_panel(id);
  if (!row) return no_such_panel(id);
  if (row->place == PanelPlace::over && act->of_columns)
    return usage_error("the panel " + id + " lies over the view: it is opened and closed, by on and off",
                       "パネル " + id + " は画面に重なるもので、on と off で開閉するだけです");
  act->act(layout, *row);
  return {};
}

std::string panel_syntax() { return "ID|none [" + joined_ids(panel_acts) + "]"; }

Outcome run_menu(Layout& layout, Words arguments, std::string_view) {
  const MenuRow* const menu = arguments.empty() ? menu_bar : find_menu(arguments[0]);
  if (!menu || arguments.size() > 1) return wrong_arguments("menu");
  layout.asked_menu = menu;
  return {};
}

Outcome run_columns(Layout& layout, Words arguments, std::string_view) {
  const std::string_view side = arguments.size() == 2 ? arguments[0] : "";
  if (side != "left" && side != "right") return wrong_arguments("columns");
  const std::optional<std::uint32_t> width = count_of(arguments.subspan(1));
  if (!width) return wrong_arguments("columns");
  if (*width < least_column_px || *width > most_column_px) {
    const std::string least = std::to_string(least_column_px), most = std::to_string(most_column_px);
    return usage_error("a column is between " + least + " and " + most + " pixels wide",
                       "列の幅は " + least + " から " + most + " までです");
  }
  layout.width_px(side == "left" ? PanelPlace::left : PanelPlace::right) = static_cast<int>(*width);
  return {};
}

Outcome run_values(Layout& layout, Words arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("values");
  const AlgorithmRow* const row = find_algorithm(arguments[0]);
  const OpInfo* const op = row ? nullptr : find_op(arguments[0]);
  const std::string called(arguments[0]);
  if (!row && !op) {
    std::vector<std::string> ids = ids_of_rows(algorithm_table());
    for (const OpInfo& other : all_ops())
      if (has_values(other)) ids.emplace_back(other.id);
    return usage_error(
        Text{"there is no algorithm or operator '" + called + "'", "アルゴリズムや操作「" + called + "」はありません"} +
        did_you_mean(called, ids));
  }
  if (op && !has_values(*op))
    return usage_error("'" + called + "' takes nothing but elements", "「" + called + "」が取るのは要素だけです");
  layout.asked_algorithm = row ? row->id : "";
  layout.asked_operator = op ? op->id : "";
  layout.show(panel_opened_by(PanelOpener::asked_values), true);
  return {};
}

Outcome run_language(Preferences& preferences, Words arguments, std::string_view) {
  const std::string_view word = arguments.size() == 1 ? arguments[0] : "";
  if (word != "en" && word != "ja") return wrong_arguments("language");
  preferences.language = word == "ja" ? Language::japanese : Language::english;
  return {};
}

Outcome run_quit(Frontend& frontend, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("quit");
  if (frontend.quit) frontend.quit();
  return {};
}

std::string preference_ids() {
  std::string ids;
  for (const PreferenceRow& row : preference_table())
    ids.append(ids.empty() ? "" : ", ").append(row.field.id).append(" ").append(placeholder(row.field));
  return ids;
}

std::string prefer_syntax() { return "ID VALUE|initial, or all initial"; }

Outcome run_prefer(Session& session, Words arguments, std::string_view) {
  if (arguments.size() != 2) return wrong_arguments("prefer");
  if (arguments[0] == "all" && arguments[1] == "initial") {
    for (const PreferenceRow& row : preference_table()) prefer(session, row.field.id, "initial");
    return {};
  }
  const auto fault = prefer(session, arguments[0], arguments[1]);
  return fault ? usage_error("prefer: " + fault->en, "prefer：" + fault->ja) : Outcome();
}

namespace {

bool is_all_initial(Words arguments) {
  return arguments.size() == 2 && arguments[0] == "all" && arguments[1] == "initial";
}

// The command behind the chord.
std::string command_behind(std::string_view whole) { return std::string(behind_word(without_blanks(whole))); }

}  // namespace

std::optional<Text> fault_of_bind(Words arguments, const std::string& line) {
  if (is_all_initial(arguments)) return std::nullopt;
  if (arguments.size() < 2) return wrong_arguments("bind").sentence;
  const auto fault = fault_of_binding(arguments[0], command_behind(behind_word(line)));
  return fault ? std::optional(Text{"bind: " + fault->en, "bind：" + fault->ja}) : std::nullopt;
}

Outcome run_bind(Preferences& preferences, Words arguments, std::string_view whole) {
  if (is_all_initial(arguments)) {
    preferences.bindings.clear();
    return {};
  }
  if (const auto fault = fault_of_bind(arguments, "bind " + std::string(whole))) return usage_error(*fault);
  const std::string chord = *chord_from(arguments[0]), command = command_behind(whole);
  if (command == "initial") {
    bind(preferences, chord, BindTo::preset);
    return {};
  }
  const std::string wanted = command == "none" ? std::string() : command;
  const auto conflict = conflict_of(preferences, chord, wanted);
  bind(preferences, chord, BindTo::command, wanted);
  Outcome outcome;
  if (!conflict || wanted.empty()) return outcome;
  const Text lost = help_of_key(*conflict);
  outcome.sentence = {chord + " did '" + lost.en + "' (" + conflict->command +
                          ") before; bind another key to that, or take this back by: bind " + chord + " initial",
                      chord + " は「" + lost.ja + "」（" + conflict->command +
                          "）でした。別のキーを割り当てるか、bind " + chord + " initial で元に戻せます。"};
  return outcome;
}

}  // namespace ryosen
