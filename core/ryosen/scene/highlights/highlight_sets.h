// The sets of elements that highlights mark, kept current through edits: those of problems always, the others from when
// somebody looks at them.
#pragma once

#include <bitset>
#include <span>
#include <vector>

#include "ryosen/analysis/problem_sets.h"
#include "ryosen/scene/highlights/highlight_table.h"

namespace ryosen {

class HighlightSets {
 public:
  HighlightSets() = default;
  // Searches for problems, see ProblemSets.
  explicit HighlightSets(const Mesh& mesh, unsigned threads = 0, std::span<const Vertex> on_lines = {})
      : problems_(mesh, threads, on_lines) {}

  const ProblemSets& problems() const { return problems_; }
  const IndexSet& of(ProblemKind kind) const { return problems_.of(kind); }
  std::uint32_t count(ProblemKind kind) const { return problems_.count(kind); }
  // See ProblemSets.
  void put_findings(ProblemKind kind, std::span<const std::uint32_t> found) { problems_.put_findings(kind, found); }
  bool put_member(const ProblemRow& row, std::uint32_t index, bool is_member) {
    return problems_.put_member(row, index, is_member);
  }
  ElementCounts counts_on_points(const Mesh& mesh) const { return problems_.counts_on_points(mesh); }

  // Whether the sets of a highlight are there. Those of problems are; what predicates of its own mark is searched for
  // by keep(), O(corners), and kept current until forget().
  bool keeps(const HighlightRow& row) const { return !row.has_predicate() || kept_[number_of(row)]; }
  void keep(const Mesh& mesh, const HighlightRow& row, unsigned threads = 0);
  void forget(const HighlightRow& row);

  // The members of a mark, as slot numbers; of a highlight that it keeps.
  const IndexSet& of(Mark mark) const;
  // The members of all marks of a highlight that it keeps. An element that several of its kinds name counts for each.
  std::uint64_t count(const HighlightRow& row) const;

  // After transaction i of the journal was committed, undone or redone on the mesh: the sets are those of a fresh
  // search. Asks around what it wrote, as the rows say; only a transaction that replaces all columns is searched anew.
  void update(const Mesh& mesh, const Journal& journal, std::size_t i);
  // What the last update put in or took out; nothing is listed where everything may have changed.
  struct Change {
    Mark mark;
    std::uint32_t index;
  };
  std::span<const Change> changes() const { return changes_; }
  bool changed_everything() const { return problems_.changed_everything(); }

  friend bool operator==(const HighlightSets& a, const HighlightSets& b) {
    return a.problems_ == b.problems_ && a.kept_ == b.kept_ && a.own_ == b.own_;
  }

 private:
  static std::size_t number_of(const HighlightRow& row) {
    return static_cast<std::size_t>(&row - highlight_table().data());
  }
  void update_kept(const Mesh& mesh, const Journal& journal, std::size_t i);

  ProblemSets problems_;
  std::bitset<most_highlights> kept_;
  std::vector<IndexSet> own_;  // by the number of the mark; empty while nothing is kept
  std::vector<Change> changes_;
};

}  // namespace ryosen
