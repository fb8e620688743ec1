#include "app/editor/command_functions.h"

#include <algorithm>

#include "app/editor/keys.h"
#include "app/editor/panel_list.h"
#include "app/editor/script.h"

namespace ryosen {

namespace {

// Which of the words the one argument is.
std::optional<std::size_t> one_of(Words arguments, std::initializer_list<std::string_view> words) {
  const auto found = arguments.size() == 1 ? std::find(words.begin(), words.end(), arguments[0]) : words.end();
  if (found == words.end()) return std::nullopt;
  return static_cast<std::size_t>(found - words.begin());
}

Outcome no_such_panel(const std::string& id) {
  std::vector<std::string> known;
  for (const PanelRow& row : panel_list()) known.emplace_back(row.id);
  const Text hint = did_you_mean(id, known), all{"; known: " + panel_ids(), "。あるのは " + panel_ids()};
  return usage_error(Text{"there is no panel '" + id + "'", "パネル「" + id + "」はありません"} +
                     (hint.en.empty() ? all : hint));
}

}  // namespace

Outcome run_panel(Session& session, Words arguments, std::string_view) {
  if (arguments.empty() || arguments.size() > 2) return wrong_arguments("panel");
  const bool on = arguments.size() == 1 || arguments[1] == "on";
  if (!on && arguments[1] != "off") return wrong_arguments("panel");
  const std::string id(arguments[0]);
  if (id == "none" && arguments.size() == 1) {
    session.open_panel.clear();
    return {};
  }
  const PanelRow* const row = find_panel(id);
  if (!row) return no_such_panel(id);
  if (row->place == PanelPlace::over && (on || session.open_panel == id)) session.open_panel = on ? id : "";
  if (row->place != PanelPlace::over && on) session.hidden_panels.erase(id);
  if (row->place != PanelPlace::over && !on) session.hidden_panels.insert(id);
  return {};
}

Outcome run_values(Session& session, Words arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("values");
  const AlgorithmRow* const row = find_algorithm(arguments[0]);
  if (!row) {
    std::vector<std::string> known;
    for (const AlgorithmRow& other : algorithm_table()) known.emplace_back(other.id);
    const std::string wrong(arguments[0]);
    return usage_error(Text{"there is no algorithm '" + wrong + "'", "アルゴリズム「" + wrong + "」はありません"} +
                       did_you_mean(wrong, known));
  }
  session.asked_algorithm = row->id;
  session.open_panel = "values";
  return {};
}

Outcome run_language(Session& session, Words arguments, std::string_view) {
  const auto which = one_of(arguments, {"en", "ja"});
  if (!which) return wrong_arguments("language");
  session.language = *which == 1 ? Language::japanese : Language::english;
  return {};
}

Outcome run_theme(Session& session, Words arguments, std::string_view) {
  const auto which = one_of(arguments, {"dark", "light"});
  if (!which) return wrong_arguments("theme");
  session.light_theme = *which == 1;
  return {};
}

// One step out of what was begun: first the open panel, then the tool, then the selection.
Outcome run_cancel(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("cancel");
  if (!session.open_panel.empty()) return session.run("panel none");
  if (!session.tool.empty()) return session.run("tool none");
  return session.run("select none");
}

std::string sent_by_key(Words arguments) {
  const KeyRow* const key = arguments.size() == 1 ? find_key(arguments[0]) : nullptr;
  return key ? std::string(key->command) : std::string();
}

Outcome run_key(Session& session, Words arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("key");
  const KeyRow* key = find_key(arguments[0]);
  if (!key)
    return usage_error("no key '" + std::string(arguments[0]) + "' (see ryosen keys)",
                       "キー「" + std::string(arguments[0]) + "」はありません（ryosen keys を参照）");
  return session.run(std::string(key->command));
}

Outcome run_quit(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("quit");
  if (session.quit) session.quit();
  return {};
}

}  // namespace ryosen
