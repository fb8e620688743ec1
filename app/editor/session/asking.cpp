#include "app/editor/session/asking.h"

#include <utility>
#include <vector>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/session/session.h"
#include "ryosen/base/split_list.h"
#include "ryosen/io/elements.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/lines/syntax.h"

namespace ryosen {

namespace {

constexpr std::pair<std::string_view, PickMode> samples[] = {
    {"v0", PickMode::vertex}, {"0-1", PickMode::edge}, {"f0", PickMode::face}};

struct OpLine {
  const OpInfo* op = nullptr;
  std::vector<std::string_view> arguments;

  explicit OpLine(std::string_view line) : arguments(split_words(line)) {
    if (arguments.empty()) return;
    op = find_op(arguments[0]);
    arguments.erase(arguments.begin());
  }
  bool is_complete() const { return !first_misfit(op->syntax, arguments); }
  bool is_answered() const { return is_complete() && op->syntax.find("...") == std::string_view::npos; }
};

// How many more elements of any kind a line takes that is no operator's.
std::size_t room_for_any(std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  const auto row = words.empty() || find_op(words[0]) ? std::nullopt : find_command_row(words[0]);
  return row && words.size() <= row->most_elements ? row->most_elements + 1 - words.size() : 0;
}

}  // namespace

std::optional<PickMode> asked_for(std::string_view line) {
  OpLine op_line(line);
  if (!op_line.op || op_line.is_answered()) return std::nullopt;
  op_line.arguments.emplace_back();
  for (const auto& [name, mode] : samples) {
    op_line.arguments.back() = name;
    const auto misfit = first_misfit(op_line.op->syntax, op_line.arguments);
    if (!misfit || *misfit == op_line.arguments.size()) return mode;
  }
  return std::nullopt;
}

bool can_be_asked(std::string_view line) { return asked_for(line) || room_for_any(line) > 0; }

bool is_answered(std::string_view line) {
  const OpLine op_line(line);
  return op_line.op ? op_line.is_answered() : room_for_any(line) == 0;
}

Text asked_text(std::string_view line) {
  const std::string said(line);
  if (!can_be_asked(line)) return {said, said};
  Text point{"Point at an element.", "要素を指してください。"};
  if (const auto mode = asked_for(line)) {
    const PickModeRow& row = pick_modes[static_cast<std::size_t>(*mode)];
    point = {std::string(row.point_en), std::string(row.point_ja)};
  }
  Text text = Text{said + ": ", said + "："} + point;
  if (!fault_of_command(said)) text = text + Text{" Enter carries it out.", "Enter で実行します。"};
  return text;
}

Outcome answer(Session& session, glm::dvec2 pixel) {
  const auto picked = can_be_asked(session.selecting.asked_line) ? session.pointing.pick(pixel, session.selecting.pointed_sort()) : std::nullopt;
  if (!picked) return failed(ExitCode::found_problems, asked_text(session.selecting.asked_line));
  session.selecting.asked_line += " " + session.selecting.names_of({picked->element})[0];
  if (!is_answered(session.selecting.asked_line)) return {};
  return carry_out_asked(session);
}

Outcome carry_out_asked(Session& session) {
  const std::string line = std::exchange(session.selecting.asked_line, {});
  Outcome outcome = session.run(line);
  if (!outcome.done()) session.selecting.asked_line = line.substr(0, line.find(' '));
  return outcome;
}

}  // namespace ryosen
