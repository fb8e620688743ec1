// Many edges collapsed one after another: the same mesh as by one call each, at the cost of the smaller end of each
// edge.
//
// By itself a call looks at both ends and renames the halfedges of the one that goes, which is quadratic where one
// vertex meets all others. Here the smaller of two ends takes over the slot of the larger, and the number that the
// vertex goes by is kept beside it until the end. n edges cost n log n looks at halfedges.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/rules/local_facts.h"

namespace ryosen {

class CollapseSeries : public OneByOne {
 public:
  explicit CollapseSeries(Edit& edit) : OneByOne(edit) {}

  std::optional<Rule> broken_rule(const AnyOp& op) override;
  void apply(const AnyOp& op) override;
  Vertex number(Vertex slot) const override;
  // Gives the vertices their numbers. Until then the mesh has others.
  void finish() override;

  // Halfedges that were looked at to rename them and to count gaps: what the work is measured by.
  std::uint64_t looks() const { return looks_; }

 private:
  const Mesh& mesh() const { return edit_.mesh(); }
  std::uint32_t gaps(Vertex v);
  bool kept_is_smaller(Halfedge h);
  Halfedge only_gap_left(Halfedge h) const;
  Halfedge first_gap_clockwise(Halfedge from);
  void join(Halfedge h, std::optional<glm::dvec3> moved);
  void give_number(Vertex slot, Vertex other, Vertex stays);

  LocalFacts known_;
  std::unordered_map<Vertex, Vertex> numbers_;      // by slot, where it is another
  std::unordered_map<Vertex, std::uint32_t> gaps_;  // outside halfedges that leave it, by slot
  std::uint64_t looks_ = 0;
};

}  // namespace ryosen
