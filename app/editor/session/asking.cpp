#include "app/editor/session/asking.h"

#include <utility>
#include <vector>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/session/session.h"
#include "ryosen/base/split_list.h"
#include "ryosen/io/edited_file.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/parameters/op_line.h"

namespace ryosen {

namespace {

struct OpWords {
  const OpInfo* op = nullptr;
  std::vector<std::string_view> arguments;

  explicit OpWords(std::string_view line) : arguments(split_words(line)) {
    if (arguments.empty()) return;
    op = find_op(arguments[0]);
    arguments.erase(arguments.begin());
  }
  bool is_answered() const { return !first_misfit(op->line, op_arguments(arguments)) && !takes_any_number(op->line); }
};

// How many more elements of any kind a line takes that is no operator's.
std::size_t room_for_any(std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  const CommandRow* const row = words.empty() || find_op(words[0]) ? nullptr : find_command_row(words[0]);
  return row && words.size() <= row->most_elements ? row->most_elements + 1 - words.size() : 0;
}

}  // namespace

std::optional<PickMode> asked_for(std::string_view line) {
  const OpWords said(line);
  if (!said.op || said.is_answered()) return std::nullopt;
  const auto kind = next_element(said.op->line, op_arguments(said.arguments));
  if (!kind) return std::nullopt;
  return *kind == Element::Kind::vertex ? PickMode::vertex
         : *kind == Element::Kind::face ? PickMode::face
                                        : PickMode::edge;
}

bool can_be_asked(std::string_view line) { return asked_for(line) || room_for_any(line) > 0; }

bool is_answered(std::string_view line) {
  const OpWords said(line);
  return said.op ? said.is_answered() : room_for_any(line) == 0;
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
  if (!fault_of_command(said)) text += Text{" Enter carries it out.", "Enter で実行します。"};
  return text;
}

Outcome answer(Session& session, glm::dvec2 pixel) {
  const auto picked = can_be_asked(session.selecting.asked_line)
                          ? session.pointing.pick(pixel, session.selecting.pointed_sort())
                          : std::nullopt;
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
