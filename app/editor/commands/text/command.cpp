#include "app/editor/commands/text/command.h"

#include "ryosen/ops/all.h"

namespace ryosen {

std::string AlgorithmCall::line() const {
  const std::string words = values.line(has_unnamed_value);
  return called(*row, is_called_repair) + (words.empty() ? "" : " " + words);
}

std::string Command::line(const Mesh& mesh) const {
  if (const AnyOp* const it = op()) return command_of(mesh, *it);
  if (const AlgorithmCall* const call = algorithm()) return call->line();
  return *written();
}

std::string called(const AlgorithmRow& algorithm, bool as_repair) {
  const std::string id(algorithm.id);
  return as_repair || find_op(id) ? "repair " + id : id;
}

std::string select_line(const Selector& row) {
  return "select " + std::string(row.id) + (row.usual.empty() ? "" : " " + std::string(row.usual));
}

std::string select_line(const ProblemRow& row, std::string_view element) {
  const std::string line = "select " + std::string(of_problem) + " " + std::string(row.id);
  return element.empty() ? line : line + " " + std::string(element);
}

}  // namespace ryosen
