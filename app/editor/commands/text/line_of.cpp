#include "app/editor/commands/text/line_of.h"

#include "ryosen/ops/all.h"

namespace ryosen {

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
