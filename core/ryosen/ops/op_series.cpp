#include "ryosen/ops/op_series.h"

namespace ryosen {

std::optional<Rule> OneByOne::broken_rule(const AnyOp& op) {
  const Verdict verdict = check(edit_.mesh(), op);
  return verdict.legal() ? std::nullopt : std::optional(verdict.reasons[0].rule);
}

std::optional<Rule> OneByOne::doubt(const AnyOp& op) {
  const std::vector<Reason> doubts = warnings(edit_.mesh(), op);
  return doubts.empty() ? std::nullopt : std::optional(doubts[0].rule);
}

std::unique_ptr<OpSeries> series_of(const OpInfo& op, Edit& edit) {
  return op.in_series ? op.in_series(edit) : std::make_unique<OneByOne>(edit);
}

}  // namespace ryosen
