#include "app/editor/commands/text/command.h"

#include "app/editor/commands/text/line_of.h"

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

}  // namespace ryosen
