#include "app/editor/command_functions.h"

#include "app/editor/keys.h"
#include "app/editor/panel_list.h"
#include "app/editor/script.h"

namespace ryosen {

namespace {

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
  if (id == "none" && arguments.size() > 1)
    return usage_error("panel none closes what lies over the view; it takes no further word",
                       "panel none は画面に重なるものを閉じます。後ろに言葉は付けられません");
  if (id == "none") {
    session.open_panel.clear();
    return {};
  }
  const PanelRow* const row = find_panel(id);
  if (!row) return no_such_panel(id);
  session.show(*row, on);
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
  session.show(panel_opened_by(PanelOpener::asked_values), true);
  return {};
}

Outcome run_language(Session& session, Words arguments, std::string_view) {
  const std::string_view word = arguments.size() == 1 ? arguments[0] : "";
  if (word != "en" && word != "ja") return wrong_arguments("language");
  session.language = word == "ja" ? Language::japanese : Language::english;
  return {};
}

// One step out of what was begun: first a band, then the open panel, a held verdict, the tool, the selection.
Outcome run_cancel(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("cancel");
  if (session.band || session.armed_gesture) {
    session.band.reset();
    session.armed_gesture.reset();
    return {};
  }
  if (!session.open_panel.empty()) return session.run("panel none");
  if (session.is_verdict_held()) {
    session.release_verdict();
    session.point_away();
    return {};
  }
  if (!session.tool.empty()) return session.run("tool none");
  return session.run("select none");
}

Outcome run_quit(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("quit");
  if (session.quit) session.quit();
  return {};
}

}  // namespace ryosen
