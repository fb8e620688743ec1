#include "tests/support/core/oracle/comparison.h"

namespace ryosen::oracle {

std::string to_text(const Disagreement& disagreement) {
  std::string text = to_text(disagreement.operation) + " on " + to_text(disagreement.mesh) + ": oracle says " +
                     (disagreement.oracle_legal ? "legal" : "illegal") + ", the other " +
                     (disagreement.other_legal ? "legal" : "illegal");
  for (const std::string& reason : disagreement.reasons) text += "\n    " + reason;
  return text;
}

std::vector<Disagreement> compare(const PolygonList& points, const std::function<bool(const Operation&)>& other_legal) {
  std::vector<Disagreement> found;
  const Judge judge(read_copies(points));
  for (const Operation& operation : operations_of(points)) {
    const Reasons reasons = judge.reasons(operation);
    const bool other = other_legal(operation);
    if (reasons.empty() != other) found.push_back({points, operation, reasons.empty(), other, reasons});
  }
  return found;
}

}  // namespace ryosen::oracle
