// A series of calls of one operator, which may cost less than the calls one by one.
#pragma once

#include <memory>
#include <optional>

#include "ryosen/ops/all.h"

namespace ryosen {

// Judges and applies each call in turn, with the results of check(), warnings() and apply(). Nothing else may change
// the mesh in between, and faces and vertices may have other numbers until finish().
class OpSeries {
 public:
  virtual ~OpSeries() = default;
  // The first rule that the call breaks.
  virtual std::optional<Rule> broken_rule(const AnyOp& op) = 0;
  // The first warning about a legal call.
  virtual std::optional<Rule> doubt(const AnyOp& op) = 0;
  // Applies the call that was judged last, which is legal.
  virtual void apply(const AnyOp& op) = 0;
  // The number of the vertex in this slot, until finish() gives it one.
  virtual Vertex number(Vertex slot) const { return slot; }
  // Called after the last call.
  virtual void finish() {}
};

// Each call by itself.
class OneByOne : public OpSeries {
 public:
  explicit OneByOne(Edit& edit) : edit_(edit) {}
  std::optional<Rule> broken_rule(const AnyOp& op) override { return first_rule_of(check(edit_.mesh(), op)); }
  std::optional<Rule> doubt(const AnyOp& op) override {
    const std::vector<Reason> doubts = warnings(edit_.mesh(), op);
    return doubts.empty() ? std::nullopt : std::optional(doubts[0].rule);
  }
  void apply(const AnyOp& op) override { ryosen::apply(edit_, op); }

 protected:
  Edit& edit_;
};

// The one that the row of the operator names, else each call by itself.
inline std::unique_ptr<OpSeries> series_of(const OpInfo& op, Edit& edit) {
  return op.in_series ? op.in_series(edit) : std::make_unique<OneByOne>(edit);
}

}  // namespace ryosen
