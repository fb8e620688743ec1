// The commands of what the pointer does: `tool`, `mode`, `click`, `ask`, `walk`, `remedy`; `box` and `lasso`, which
// select what lies in a region of the picture, and `band`, which makes the next drag one of them.
#include <algorithm>

#include "app/editor/camera/camera_text.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/fly.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/session/asking.h"
#include "app/editor/session/session.h"
#include "app/editor/texts/remedy_text.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/index_set.h"
#include "ryosen/base/rows.h"
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
  const PickModeRow* const row = arguments.size() == 1 ? find_row(pick_modes, arguments[0]) : nullptr;
  if (!row) return wrong_arguments("mode");
  selecting.mode = row->mode;
  selecting.release_verdict();
  if (selecting.hover()) pointing.point_at(selecting.hover()->pixel, selecting.hover()->modifiers);
  return {};
}

Outcome run_click(const Selecting& selecting, Pointing& pointing, Words arguments, std::string_view) {
  const auto at = arguments.empty() ? std::nullopt : parse_pixel(arguments[0]);
  if (!at || arguments.size() > 2) return wrong_arguments("click");
  if (arguments.size() == 2 && !find_tool(arguments[1])) return not_a_tool(arguments[1]);
  return pointing.click(*at, arguments.size() == 2 ? std::string(arguments[1]) : selecting.tool);
}

std::optional<Text> fault_of_remedy(Words arguments, const std::string&) {
  return fault_unless(count_of(arguments).has_value(), "remedy");
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

namespace {

struct RegionCall {
  std::vector<glm::dvec2> pixels;
  SelectHow how = SelectHow::anew;
  Picker::Depth depth = Picker::Depth::seen;
};

// X,Y X,Y ... [add|toggle] [through]
std::optional<RegionCall> read_region(Words arguments, std::size_t least, std::size_t most) {
  RegionCall call;
  for (const std::string_view word : arguments) {
    if (const auto pixel = parse_pixel(word))
      call.pixels.push_back(*pixel);
    else if (word == "add" || word == "toggle")
      call.how = word == "add" ? SelectHow::add : SelectHow::toggle;
    else if (word == "through")
      call.depth = Picker::Depth::through;
    else
      return std::nullopt;
  }
  return call.pixels.size() >= least && call.pixels.size() <= most ? std::optional(call) : std::nullopt;
}

Outcome select_in(Session& session, const RegionCall& call, const ScreenRegion& region) {
  const Picker::Depth depth = call.depth == Picker::Depth::seen ? pick_depth(session.view) : call.depth;
  if (session.shown.is_replaced()) return session.shown.refusal();
  if (session.findings().preparing())
    return failed(ExitCode::refused, {"the mesh is still being prepared; try again in a moment",
                                      "メッシュの準備中です。少し待ってからやり直してください"});
  const Elements found =
      session.findings()
          .picker(session.view)
          .pick_region(session.mesh(), session.view.camera, session.view.size, region, session.selecting.mode, depth);
  put_into_selection(session.selecting.selection.changed(), found, call.how);
  Outcome outcome;
  if (found.empty())
    outcome.sentence =
        depth == Picker::Depth::seen
            ? Text{"nothing lies wholly in there and is seen; ", "全体が収まり見えている要素はありません。"}
            : Text{"nothing lies wholly in there; ", "全体が収まる要素はありません。"};
  outcome.sentence += count_text(session.selecting.selection.size(), "one element is selected",
                                 "# elements are selected", "# 個を選択しています");
  return outcome;
}

}  // namespace

Outcome run_box(Session& session, Words arguments, std::string_view) {
  auto call = read_region(arguments, 2, 2);
  if (!call) return wrong_arguments("box");
  return select_in(session, *call,
                   ScreenRegion::box(call->pixels[0] - session.view.origin, call->pixels[1] - session.view.origin));
}

Outcome run_lasso(Session& session, Words arguments, std::string_view) {
  auto call = read_region(arguments, 1, arguments.size());
  if (!call) return wrong_arguments("lasso");
  for (glm::dvec2& pixel : call->pixels) pixel -= session.view.origin;
  return select_in(session, *call, ScreenRegion(call->pixels));
}

Outcome run_band(ViewState& view, Words arguments, std::string_view) {
  const std::string_view word = arguments.size() == 1 ? arguments[0] : "";
  if (word != "box" && word != "lasso") return wrong_arguments("band");
  view.armed_drag = word == "box" ? DragAction::box : DragAction::lasso;
  return {};
}

}  // namespace ryosen
