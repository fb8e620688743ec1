#include "app/editor/commands/command_functions.h"

#include <algorithm>

#include "app/editor/camera/camera_text.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/fly.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/session/asking.h"
#include "app/editor/session/session.h"
#include "app/editor/texts/remedy_text.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

// An operator that works on what the pointer is on.
const OpInfo* find_tool(std::string_view id) {
  const OpInfo* op = find_op(id);
  return op && is_tool(*op) ? op : nullptr;
}

Outcome not_a_tool(std::string_view id) {
  const std::string name(id);
  if (!find_op(id)) {
    std::vector<std::string> tools;
    for (const OpInfo& op : all_ops())
      if (is_tool(op)) add_ids(op, tools);
    return usage_error(Text{"'" + name + "' is not a tool", "「" + name + "」はツールではありません"} +
                       did_you_mean(name, tools));
  }
  return usage_error(name + " does not work on what is clicked; say it as a command",
                     name + " はクリックした要素に働く操作ではないので、コマンドとして実行してください");
}

}  // namespace

Outcome run_walk(Findings& findings, ViewState& view, Framing& framing, Selecting& selecting, Words arguments,
                 std::string_view) {
  const std::string_view where = arguments.size() == 1 ? arguments[0] : "";
  if (where != "next" && where != "prev" && where != "twin" && where != "around") return wrong_arguments("walk");
  if (selecting.selection.size() != 1 || selecting.selection[0].kind != Element::Kind::halfedge)
    return failed(ExitCode::refused, {"select one halfedge first; halfedges are walked from there",
                                      "先に半稜線を一つ選択してください。そこから辿ります"});
  const Mesh& mesh = findings.mesh();
  const Halfedge h = selecting.selection[0].halfedge();
  selecting.selection = {where == "next"   ? mesh.next(h)
                         : where == "prev" ? mesh.prev(h)
                         : where == "twin" ? twin(h)
                                           : mesh.counter_clockwise(h)};
  view.links.walked(h, selecting.selection[0].halfedge());
  keep_in_sight(findings, view, framing, selecting.selection[0]);
  return {};
}

Outcome run_tool(Selecting& selecting, Pointing& pointing, Words arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("tool");
  if (arguments[0] != "none" && !find_tool(arguments[0])) return not_a_tool(arguments[0]);
  selecting.tool = arguments[0] == "none" ? "" : std::string(arguments[0]);
  selecting.asked_line.clear();
  selecting.release_verdict();
  if (selecting.hover()) pointing.point_at(selecting.hover()->pixel, selecting.hover()->modifiers);
  return {};
}

std::optional<Text> fault_of_ask(Words arguments, const std::string& line) {
  if (arguments.empty() || can_be_asked(behind_word(line))) return std::nullopt;
  return behind("ask", {"'" + std::string(behind_word(line)) + "' lacks no element that could be pointed at",
                        "「" + std::string(behind_word(line)) + "」には指して与える要素がありません"});
}

Outcome run_ask(Session& session, Words arguments, std::string_view whole) {
  if (const auto fault = fault_of_ask(arguments, "ask " + std::string(whole))) return usage_error(*fault);
  if (!arguments.empty()) {
    session.selecting.tool.clear();
    session.selecting.asked_line = without_blanks(whole);
    session.selecting.release_verdict();
    return {};
  }
  if (session.selecting.asked_line.empty())
    return failed(ExitCode::refused, {"no operator asks for elements", "要素を待っている操作はありません"});
  if (fault_of_command(session.selecting.asked_line))
    return failed(ExitCode::refused, asked_text(session.selecting.asked_line));
  return carry_out_asked(session);
}

Outcome run_mode(Selecting& selecting, Pointing& pointing, Words arguments, std::string_view) {
  for (const auto& [mode, id, point_en, point_ja, help_en, help_ja] : pick_modes) {
    if (arguments.size() != 1 || arguments[0] != id) continue;
    selecting.mode = mode;
    selecting.release_verdict();
    if (selecting.hover()) pointing.point_at(selecting.hover()->pixel, selecting.hover()->modifiers);
    return {};
  }
  return wrong_arguments("mode");
}

Outcome run_click(const Selecting& selecting, Pointing& pointing, Words arguments, std::string_view) {
  const auto at = arguments.empty() ? std::nullopt : parse_pixel(arguments[0]);
  if (!at || arguments.size() > 2) return wrong_arguments("click");
  if (arguments.size() == 2 && !find_tool(arguments[1])) return not_a_tool(arguments[1]);
  return pointing.click(*at, arguments.size() == 2 ? std::string(arguments[1]) : selecting.tool);
}

std::optional<Text> fault_of_remedy(Words arguments, const std::string&) {
  return count_of(arguments) ? std::nullopt : std::optional(wrong_arguments("remedy").sentence);
}

Outcome run_remedy(Session& session, Words arguments, std::string_view) {
  const auto number = count_of(arguments);
  if (!number) return wrong_arguments("remedy");
  if (!session.selecting.is_verdict_held())
    return failed(ExitCode::refused,
                  {"there is nothing to carry out here: no click was refused, and nothing waits for elements",
                   "ここで実行することはありません。拒否されたクリックも、要素を待っている操作もありません"});
  const std::vector<std::string> lines = session.selecting.hover_remedy();
  if (lines.empty()) return failed(ExitCode::refused, without_remedy(session.selecting.hover()->preview.verdict));
  if (*number > lines.size())
    return failed(ExitCode::refused, {"the remedy has only " + std::to_string(lines.size()) + " lines",
                                      "対処は " + std::to_string(lines.size()) + " 行しかありません"});
  return session.run(lines[*number - 1]);
}

}  // namespace ryosen
