// What is played: steps in order, each made when it is asked for, and the mesh as it is between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/base/verdict.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/steps/step.h"

namespace ryosen::steps {

// The table that steps write of the elements of a kind: vertices, halfedges, edges, faces.
std::string_view table_of(Element::Kind kind);

// A number that grows with the steps.
struct Curve {
  Text name;
  // Behind step 1, 2, ...; of steps that are made only when they are asked for those that were so far.
  std::span<const std::uint32_t> values;
};

// Why the steps end before what is played does: something is refused, or is not as it was said to be.
struct Stop {
  ExitCode exit_code;
  Text sentence;
  std::vector<Reason> reasons;  // about the mesh behind the last step
};

// Step i, from 1, leads from state i - 1 to state i; state 0 is before the first one. Steps may be asked for in any
// order; the same one is always the same. Not for two threads at a time.
class Sequence {
 public:
  virtual ~Sequence() = default;

  virtual std::size_t size() const = 0;
  // 1 <= i <= size().
  virtual Step at(std::size_t i) = 0;
  // The kernel's mesh in state i, 0 <= i <= size(); valid until the sequence is asked again.
  virtual const Mesh& mesh_at(std::size_t i) = 0;
  // Whether the mesh of some state differs from that of another; where none does, the sequence began with it.
  virtual bool edits() const = 0;
  // What is to be said of the whole, such as that only the first faces are played; usually empty.
  virtual Text remark() const { return {}; }
  // What is shown along the steps; valid until the sequence is asked again.
  virtual std::optional<Curve> curve() const { return {}; }
  // Why it ends with its last step; usually it does not end early.
  const std::optional<Stop>& stop() const { return stop_; }
  void stop_for(std::optional<Stop> why) { stop_ = std::move(why); }

 private:
  std::optional<Stop> stop_;
};

// Steps that are known beforehand, on a mesh that some of them edit: each edit is transactions of the journal. To a
// step that edits, at() adds what the edit changes: rows, marks, delta, and the delta's text behind the caption. At
// most most_rows rows; the caption says how many more there are.
class RecordedSteps : public Sequence {
 public:
  static constexpr std::size_t most_rows = 1000;

  // No step edits.
  RecordedSteps(Mesh mesh, std::vector<Step> steps, Text remark = {});
  // `positions`: that of the journal behind each step, ascending; the mesh is as behind the last one.
  RecordedSteps(Mesh mesh, Journal journal, std::vector<Step> steps, std::vector<std::size_t> positions,
                Text remark = {});

  std::size_t size() const override { return steps_.size(); }
  Step at(std::size_t i) override;
  const Mesh& mesh_at(std::size_t i) override;
  bool edits() const override { return journal_.size() > 0; }
  Text remark() const override { return remark_; }

 private:
  std::size_t position_behind(std::size_t i) const { return i == 0 ? 0 : positions_[i - 1]; }
  void go_to(std::size_t position);
  void add_changes(Step& step, std::size_t from, std::size_t to);

  Mesh mesh_;
  Journal journal_;
  std::vector<Step> steps_;
  std::vector<std::size_t> positions_;
  Text remark_;
};

}  // namespace ryosen::steps
