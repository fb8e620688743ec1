// The one table of what can be marked on a mesh: findings of problems, and what is no problem.
//
// To add a highlight, write its row, with a predicate where it marks no problem, and with a pair of line style and
// point shape that no other has which may lie on the same element; golden pictures of the panels show it too. The
// panel, the drawing, the legend, the commands and their help read the table.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/base/element.h"
#include "ryosen/scene/highlights/looks.h"

namespace ryosen {

// A set of kinds that is known when it is compiled.
class ProblemKinds {
 public:
  constexpr ProblemKinds() = default;
  constexpr ProblemKinds(std::initializer_list<ProblemKind> kinds) {
    for (ProblemKind kind : kinds) bits_ |= bit(kind);
  }
  constexpr bool contains(ProblemKind kind) const { return (bits_ & bit(kind)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }

 private:
  static_assert(most_problem_kinds <= 32);
  static constexpr std::uint32_t bit(ProblemKind kind) { return std::uint32_t{1} << static_cast<unsigned>(kind); }
  std::uint32_t bits_ = 0;
};

// It marks the findings of kinds of problems, or the elements about which predicates of its own say so. Findings are
// there anyway; what predicates mark is searched for while the highlight is shown, and costs nothing else.
struct HighlightRow {
  std::string_view id;  // as in the commands
  std::string_view name_en, name_ja;
  std::string_view legend_en, legend_ja;  // what it marks, in a sentence
  ProblemKinds kinds = {};

  // Asked about live elements. An edge or vertex that is several in the kernel answers yes for one only, see
  // ProblemRow.
  bool (*vertex)(Neighbourhood&, Vertex) = nullptr;
  bool (*edge)(Neighbourhood&, Edge) = nullptr;
  bool (*face)(Neighbourhood&, Face) = nullptr;
  // What predicates look at decides what is asked anew after an edit. The elements at the points that it wrote always
  // are: enough for a predicate that looks at the links and places of its element and of those that meet it there.
  bool reads_whole_faces = false;  // also at the other corners of the faces that meet it
  bool reads_values = false;       // also at the values of attributes there

  Looks looks;
  std::optional<FaceTint> tint = {};  // of the faces that it marks
  // Where lines lie on each other, those of a higher tier are on top; of one tier those that stand first in the table.
  // Wide solid ones lie lowest, so that those above leave a part of them to be seen.
  std::uint8_t tier = 0;

  bool has_predicate() const { return vertex || edge || face; }
  // Before the user has said anything: what is listed as a finding is drawn too.
  bool is_shown_at_first() const { return !kinds.empty(); }
  // It has members only when somebody has searched for them.
  bool is_on_request() const;
};

// Those of problems first, in the order of panels and lists.
std::span<const HighlightRow> highlight_table();
// How many rows of the table are drawn below this one of it.
std::size_t drawing_rank(const HighlightRow& row);
// By id; null when there is none.
const HighlightRow* find_highlight(std::string_view id);

// Adds a row at the end of the table while it lives: for programs with highlights of their own, and for tests. What
// speaks of highlights (sessions, views, HighlightSets) is made after and gone before it; no other thread reads the
// table when it comes and goes. The one made last goes first.
class ScopedHighlight {
 public:
  explicit ScopedHighlight(const HighlightRow& row);
  ~ScopedHighlight();
  ScopedHighlight(const ScopedHighlight&) = delete;
  ScopedHighlight& operator=(const ScopedHighlight&) = delete;
};

// So many rows are the most that there can be.
inline constexpr std::size_t most_highlights = 20;

// Names a set of elements of one sort: the findings of one kind of problem, or what a predicate of a highlight says.
struct Mark {
  std::uint16_t number;
  Element::Kind sort;

  friend bool operator==(const Mark&, const Mark&) = default;
};
inline constexpr std::size_t own_marks = most_highlights * enum_count<Element::Kind>;
inline constexpr std::size_t most_marks = own_marks + most_problem_kinds;

// The mark of a kind that has a predicate about elements of the mesh.
Mark mark_of(ProblemKind kind);
// The mark of the predicate about elements of this sort of a row of the table.
Mark own_mark(const HighlightRow& row, Element::Kind sort);

// Calls visit(mark) for each of a row of the table.
template <class Visit>
void for_each_own_mark(const HighlightRow& row, Visit visit) {
  if (row.vertex) visit(own_mark(row, Element::Kind::vertex));
  if (row.edge) visit(own_mark(row, Element::Kind::edge));
  if (row.face) visit(own_mark(row, Element::Kind::face));
}
template <class Visit>
void for_each_mark(const HighlightRow& row, Visit visit) {
  for (const ProblemRow& problem : problem_table())
    if ((problem.is_local() || problem.is_on_request()) && row.kinds.contains(problem.kind))
      visit(mark_of(problem.kind));
  for_each_own_mark(row, visit);
}

}  // namespace ryosen
