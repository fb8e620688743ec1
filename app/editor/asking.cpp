#include "app/editor/asking.h"

#include <utility>
#include <vector>

#include "app/editor/pick_modes.h"
#include "core/base/split_list.h"
#include "core/io/elements.h"
#include "core/ops/all.h"
#include "core/ops/lines/syntax.h"

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

bool is_answered(std::string_view line) {
  const OpLine op_line(line);
  return op_line.op && op_line.is_answered();
}

Text asked_text(std::string_view line) {
  const std::string said(line);
  const auto mode = asked_for(line);
  if (!mode) return {said, said};
  const PickModeRow& row = pick_modes[static_cast<std::size_t>(*mode)];
  Text text{said + ": " + std::string(row.point_en), said + "：" + std::string(row.point_ja)};
  if (OpLine(line).is_complete()) text = text + Text{" Enter carries it out.", "Enter で実行します。"};
  return text;
}

Outcome answer(Session& session, glm::dvec2 pixel) {
  const auto mode = asked_for(session.asked_line);
  const auto picked = mode ? session.pick(pixel, *mode) : std::nullopt;
  if (!picked) return failed(ExitCode::found_problems, asked_text(session.asked_line));
  session.asked_line += " " + session.names_of({picked->element})[0];
  if (!is_answered(session.asked_line)) return {};
  return carry_out_asked(session);
}

Outcome carry_out_asked(Session& session) {
  const std::string line = std::exchange(session.asked_line, {});
  Outcome outcome = session.run(line);
  if (!outcome.done()) session.asked_line = line.substr(0, line.find(' '));
  return outcome;
}

}  // namespace ryosen
