// Many calls of one operator, one after another: what the row of an operator may do at less cost than call by call.
#pragma once

#include <memory>
#include <optional>

#include "ryosen/ops/all.h"

namespace ryosen {

// Says and does the same as check(), warnings() and apply() of each call in its turn. In between nothing else changes
// the mesh, and numbers of faces and vertices may be others until finish().
class OpSeries {
 public:
  virtual ~OpSeries() = default;
  // The first rule that it breaks.
  virtual std::optional<Rule> broken_rule(const AnyOp& op) = 0;
  // The first warning about a legal one.
  virtual std::optional<Rule> doubt(const AnyOp& op) = 0;
  // The one that was asked about last, which is legal.
  virtual void apply(const AnyOp& op) = 0;
  // The number that a vertex goes by, where it has the slot of another one until finish().
  virtual Vertex number(Vertex slot) const { return slot; }
  // After the last call.
  virtual void finish() {}
};

// Each call by itself.
class OneByOne : public OpSeries {
 public:
  explicit OneByOne(Edit& edit) : edit_(edit) {}
  std::optional<Rule> broken_rule(const AnyOp& op) override;
  std::optional<Rule> doubt(const AnyOp& op) override;
  void apply(const AnyOp& op) override { ryosen::apply(edit_, op); }

 protected:
  Edit& edit_;
};

// The one that the row of the operator names, else each call by itself.
std::unique_ptr<OpSeries> series_of(const OpInfo& op, Edit& edit);

}  // namespace ryosen
