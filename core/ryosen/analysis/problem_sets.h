// The sets of elements of every kind in the table of problems, kept current through edits.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/analysis/coincident_points.h"
#include "ryosen/analysis/edit_reach.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/base/index_set.h"
#include "ryosen/mesh/journal.h"

namespace ryosen {

class ProblemSets {
 public:
  ProblemSets() = default;
  // Asks every element of the mesh, on several threads where that pays (0) or on so many; the sets are the same. Beside
  // copies each has a neighbourhood of its own. O(corners), and a logarithm beside copies. `on_lines` are the vertices
  // that lines beside the mesh use, for good: no isolated ones (ProblemRow::spares_lines).
  explicit ProblemSets(const Mesh& mesh, unsigned threads = 0, std::span<const Vertex> on_lines = {});

  // After transaction i of the journal was committed, undone or redone on the mesh: the sets are those of a fresh
  // search. Asks the stars of the points that it touched, so the mesh's size does not matter; only a transaction that
  // replaces all columns is searched anew.
  void update(const Mesh& mesh, const Journal& journal, std::size_t i);

  // The findings of a kind that is searched for on request (ProblemRow::is_on_request), in place of those before. The
  // next update drops them, because nobody searches again.
  void put_findings(ProblemKind kind, std::span<const std::uint32_t> found);

  // Puts an element in or takes it out, until an update asks about it: for one that is only shown elsewhere as yet
  // (ProblemRow::face_at). True where that makes a difference; changes() is not told.
  bool put_member(const ProblemRow& row, std::uint32_t index, bool is_member);

  // Slot numbers of elements of the row's sort; empty for kinds that are found
  // in the quarantine. An edge that is several sheets, or a point that has copies, is in it once.
  const IndexSet& of(ProblemKind kind) const { return sets_[static_cast<std::size_t>(kind)]; }
  std::uint32_t count(ProblemKind kind) const { return of(kind).size(); }
  // Which of the coincident points lie together, once there was an update.
  const CoincidentPoints& coincident() const { return coincident_; }

  // Points without an edge: isolated ones, and those that only lines beside the mesh use.
  std::uint32_t points_without_edge() const { return count(ProblemKind::isolated_vertex) + only_on_lines_.size(); }

  // The live points and the pairs of points joined by an edge, as files and figures count them: counts_on_points() of
  // the mesh, of which these are the sets. O(1).
  ElementCounts counts_on_points(const Mesh& mesh) const {
    return {mesh.live().vertices - further_copies_.size(), mesh.live().edges - further_sheets_.size(),
            mesh.live().faces};
  }

  // Whether a live edge is one of the other sheets of an edge on points, beside the one that counts.
  bool is_further_sheet(Edge e) const { return further_sheets_.contains(e.index); }

  // The edges, live or not, that the last update asked about: all at the points where anything changed, those that left
  // such a point, and at neighbours with copies. Ascending; nothing where everything may have changed.
  std::span<const Edge> edges_asked() const { return edges_asked_; }
  // The elements that the last update asked about; of another mesh where everything may have changed.
  const EditReach& reach() const { return reach_; }
  // What the last update put in or took out; nothing is listed where everything may have changed.
  struct Change {
    ProblemKind kind;
    std::uint32_t index;
    bool is_member;
  };
  std::span<const Change> changes() const { return changes_; }
  bool changed_everything() const { return changed_everything_; }

  friend bool operator==(const ProblemSets& a, const ProblemSets& b) {
    return a.sets_ == b.sets_ && a.only_on_lines_ == b.only_on_lines_ && a.further_copies_ == b.further_copies_ &&
           a.further_sheets_ == b.further_sheets_;
  }

 private:
  // The set that a member of a kind belongs to.
  IndexSet& set_for(const ProblemRow& row, std::uint32_t index) {
    const bool is_spared = row.spares_lines && on_lines_.contains(index);
    return is_spared ? only_on_lines_ : sets_[static_cast<std::size_t>(row.kind)];
  }
  void search(const Mesh& mesh, unsigned threads);
  void set(const ProblemRow& row, std::uint32_t index, bool is_member);
  void update_coincident(const Mesh& mesh);
  void find_further(Neighbourhood& around);
  void list_edges_asked(Neighbourhood& around);

  std::array<IndexSet, most_problem_kinds> sets_;
  CoincidentPoints coincident_;  // from the first update on
  IndexSet on_lines_, only_on_lines_;
  IndexSet further_copies_, further_sheets_;  // all but the lowest of a point, and of an edge
  EditReach reach_;
  std::vector<Edge> edges_asked_;
  std::vector<Change> changes_;
  bool changed_everything_ = true;
  bool had_copies_ = false;
};

}  // namespace ryosen
