// The sets of elements of every kind in the table of problems, kept current through edits.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/index_set.h"
#include "core/analysis/problem_kinds.h"
#include "core/mesh/journal.h"

namespace ryosen {

class HighlightSets {
 public:
  HighlightSets() = default;
  // Asks every element of the mesh. O(corners), and a logarithm beside copies.
  explicit HighlightSets(const Mesh& mesh);
  // The same with a neighbourhood that others ask as well.
  explicit HighlightSets(Neighbourhood& around);

  // After transaction i of the journal was committed, undone or redone on the mesh: the sets are those of a fresh
  // search. Asks the stars of the points that it touched, so the mesh's size does not matter; only a transaction that
  // replaces all columns is searched anew.
  void update(const Mesh& mesh, const Journal& journal, std::size_t i);

  // Slot numbers of vertices, edges or faces, by the predicate that the kind's row has; empty for kinds that are found
  // in the quarantine. An edge that is several sheets, or a point that has copies, is in it once.
  const IndexSet& of(ProblemKind kind) const { return sets_[static_cast<std::size_t>(kind)]; }
  std::uint32_t count(ProblemKind kind) const { return of(kind).size(); }

  // What the last update put in or took out; nothing is listed where everything may have changed.
  struct Change {
    ProblemKind kind;
    std::uint32_t index;
    bool is_member;
  };
  std::span<const Change> changes() const { return changes_; }
  bool changed_everything() const { return changed_everything_; }

  friend bool operator==(const HighlightSets& a, const HighlightSets& b) { return a.sets_ == b.sets_; }

 private:
  void set(ProblemKind kind, std::uint32_t index, bool is_member);

  std::array<IndexSet, problem_kinds> sets_;
  std::vector<Change> changes_;
  bool changed_everything_ = true;
  bool had_copies_ = false;
};

}  // namespace ryosen
