#include "app/editor/command_functions.h"

#include <algorithm>

#include "app/editor/camera_text.h"
#include "app/editor/command_syntax.h"
#include "app/editor/fly.h"
#include "app/editor/pick_modes.h"
#include "app/editor/remedy_text.h"
#include "app/editor/script.h"
#include "core/mesh/find_element.h"
#include "core/ops/lines/syntax.h"

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

namespace {

// What `select` is asked for: names, behind a word that says what becomes of the selection, or behind a kind of problem
// for all that one there is about.
struct Selecting {
  enum class How { anew, add, toggle };
  How how = How::anew;
  const ProblemRow* about = nullptr;
  Words names;
};

Selecting read_selecting(Words arguments) {
  if (arguments.size() == 1 && arguments[0] == "none") return {};
  Selecting asked{.names = arguments};
  const std::string_view first = arguments.empty() ? "" : arguments[0];
  if (first == "add" || first == "toggle")
    asked.how = first == "add" ? Selecting::How::add : Selecting::How::toggle;
  else if (arguments.size() == 2)
    asked.about = find_problem_row(first);
  if (asked.how != Selecting::How::anew || asked.about) asked.names = arguments.subspan(1);
  return asked;
}

// Adds what is not there yet; where wanted takes out what is.
void put_into(std::vector<Element>& selection, std::span<const Element> elements, Selecting::How how) {
  for (const Element& e : elements) {
    const auto at = std::find(selection.begin(), selection.end(), e);
    if (at == selection.end())
      selection.push_back(e);
    else if (how == Selecting::How::toggle)
      selection.erase(at);
  }
}

}  // namespace

std::optional<Text> fault_of_select(Words arguments, const std::string&) {
  const Selecting asked = read_selecting(arguments);
  if (asked.how != Selecting::How::anew && asked.names.empty()) return wrong_arguments("select").sentence;
  for (std::string_view name : asked.names)
    if (!is_element_name(name))
      return behind("select", not_understood(name, {"the name of an element", "要素の名前を"}));
  return std::nullopt;
}

Outcome run_select(Session& session, Words arguments, std::string_view) {
  const Selecting asked = read_selecting(arguments);
  if (asked.how != Selecting::How::anew && asked.names.empty()) return wrong_arguments("select");
  std::vector<Element> found;
  for (std::string_view name : asked.names) {
    const NamedElement named = find_element(session.mesh(), name);
    if (!named.element) {
      const Text sentence = session.document().quarantine_text({&name, 1}).value_or(named.sentence);
      return usage_error("select: " + sentence.en, "select：" + sentence.ja);
    }
    found.push_back(*named.element);
  }
  if (asked.about) found = session.about(*asked.about, found[0]);
  if (asked.how == Selecting::How::anew)
    session.selection = std::move(found);
  else
    put_into(session.selection, found, asked.how);
  return {};
}

Outcome run_walk(Session& session, Words arguments, std::string_view) {
  const std::string_view where = arguments.size() == 1 ? arguments[0] : "";
  if (where != "next" && where != "prev" && where != "twin" && where != "around") return wrong_arguments("walk");
  if (session.selection.size() != 1 || session.selection[0].kind != Element::Kind::halfedge)
    return failed(ExitCode::refused, {"select one halfedge first; halfedges are walked from there",
                                      "先に半稜線を一つ選択してください。そこから辿ります"});
  const Mesh& mesh = session.mesh();
  const Halfedge h = session.selection[0].halfedge();
  session.selection = {where == "next"   ? mesh.next(h)
                       : where == "prev" ? mesh.prev(h)
                       : where == "twin" ? twin(h)
                                         : mesh.counter_clockwise(h)};
  keep_in_sight(session, session.selection[0]);
  return {};
}

Outcome run_tool(Session& session, Words arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("tool");
  if (arguments[0] != "none" && !find_tool(arguments[0])) return not_a_tool(arguments[0]);
  session.tool = arguments[0] == "none" ? "" : std::string(arguments[0]);
  session.release_verdict();
  if (session.hover()) session.point_at(session.hover()->pixel, session.hover()->modifiers);
  return {};
}

Outcome run_mode(Session& session, Words arguments, std::string_view) {
  for (const auto& [mode, id, point_en, point_ja] : pick_modes) {
    if (arguments.size() != 1 || arguments[0] != id) continue;
    session.mode = mode;
    session.release_verdict();
    if (session.hover()) session.point_at(session.hover()->pixel, session.hover()->modifiers);
    return {};
  }
  return wrong_arguments("mode");
}

Outcome run_click(Session& session, Words arguments, std::string_view) {
  const auto at = arguments.empty() ? std::nullopt : parse_pixel(arguments[0]);
  if (!at || arguments.size() > 2) return wrong_arguments("click");
  if (arguments.size() == 2 && !find_tool(arguments[1])) return not_a_tool(arguments[1]);
  return session.click(*at, arguments.size() == 2 ? std::string(arguments[1]) : session.tool);
}

std::optional<Text> fault_of_remedy(Words arguments, const std::string&) {
  return count_of(arguments) ? std::nullopt : std::optional(wrong_arguments("remedy").sentence);
}

Outcome run_remedy(Session& session, Words arguments, std::string_view) {
  const auto number = count_of(arguments);
  if (!number) return wrong_arguments("remedy");
  if (!session.is_verdict_held())
    return failed(ExitCode::refused, {"no refused click is held, so there is nothing to remedy",
                                      "拒否されたクリックがないので、実行する対処もありません"});
  const std::vector<std::string> lines = session.hover_remedy();
  if (lines.empty()) return failed(ExitCode::refused, without_remedy(session.hover()->preview.verdict));
  if (*number > lines.size())
    return failed(ExitCode::refused, {"the remedy has only " + std::to_string(lines.size()) + " lines",
                                      "対処は " + std::to_string(lines.size()) + " 行しかありません"});
  return session.run(lines[*number - 1]);
}

}  // namespace ryosen
