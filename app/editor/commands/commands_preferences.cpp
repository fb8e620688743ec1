// The commands of the preferences and of the user's own keys.
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/preferences/preferences.h"
#include "app/editor/session/session.h"

namespace ryosen {

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

// What stands behind the chord.
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
