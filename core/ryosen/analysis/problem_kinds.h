// The one table of what Ryosen finds in a mesh: what each kind is called, how it is told from one element, how it
// reads.
//
// To add a kind, write its predicate and its row. Panels, reports and the figures of `check` read the table, highlights
// name the kinds that they mark.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/element.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/index_set.h"
#include "ryosen/base/message.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen {

// In the order of reports. The elements of boundary_loop are boundary edges; reports count their loops. Those of
// ring are faces; reports count their rings.
enum class ProblemKind : std::uint8_t {
  nonmanifold_edge,
  nonmanifold_vertex,
  misoriented_edge,
  degenerate_repeat,
  degenerate_area,
  duplicate_face,
  hanging_pair,
  isolated_vertex,
  nonfinite_vertex,
  quarantined_face,
  self_intersection,
  boundary_loop,
  ring,
  wire,
  coincident_points,
};
// So many rows are the most that there can be.
inline constexpr std::size_t most_problem_kinds = 20;

enum class ProblemSeverity : std::uint8_t { info, problem };

// Exactly one of the four predicates is set, or the kind is found whole or on request. Those of mesh elements are asked
// about live elements and look no further than the faces at their points; an edge or vertex that is several in the
// kernel answers yes for one only: the lowest sheet with a face, the lowest copy. A duplicate is any face but the
// lowest, a hanging pair its higher face.
struct ProblemRow {
  ProblemKind kind;
  std::string_view id;  // as in reports
  ProblemSeverity severity = ProblemSeverity::problem;
  std::string_view name_en, name_ja;
  std::string_view several_en = {};           // the name behind a number that is not one
  std::string_view one_en, many_en, many_ja;  // sentences; # stands for the number
  // Where `check` has it among its figures: its key there, and what it counts, in a sentence.
  std::string_view figure = {}, figure_en = {}, figure_ja = {};

  bool (*vertex)(Neighbourhood&, Vertex) = nullptr;
  bool (*edge)(Neighbourhood&, Edge) = nullptr;
  bool (*face)(Neighbourhood&, Face) = nullptr;
  bool (*quarantined)(const QuarantinedFace&, std::uint32_t file_vertices) = nullptr;
  // What `face` would say if the vertices were at these places, while they are moved and nothing is done yet; null
  // where places make no difference.
  bool (*face_at)(const Mesh&, Face, std::span<const glm::dvec3> places) = nullptr;
  // The command whose search finds it, which nobody makes unasked; empty where it is always known.
  std::string_view searched_by = {};
  // What one may do where no repair takes it away: a sentence.
  std::string_view by_hand_en = {}, by_hand_ja = {};
  // Speaks of vertices for themselves: the line in the file is theirs, not that of a face there.
  bool is_of_the_vertex = false;
  // Does not speak of vertices that a line beside the mesh uses.
  bool spares_lines = false;
  // All elements that one of them is about, itself the first: the loop, the fans, the pair; null where it is itself
  // alone. `members` is the set of the kind.
  std::vector<Element> (*about)(Neighbourhood&, const IndexSet& members, Element) = nullptr;
  // Finds all at once where that is quicker than asking one by one, or where none can be asked alone; ascending.
  std::vector<std::uint32_t> (*find_all)(Neighbourhood&) = nullptr;

  // Vertices, each of which depends on all others.
  bool is_found_whole() const { return find_all && !vertex && !edge && !face; }
  // Its findings are elements of the mesh, always known.
  bool is_local() const { return vertex || edge || face || is_found_whole(); }
  bool is_on_request() const { return !searched_by.empty(); }
  // What its findings are; faces too where it has no predicate about elements of the mesh.
  Element::Kind sort() const {
    return vertex || is_found_whole() ? Element::Kind::vertex : edge ? Element::Kind::edge : Element::Kind::face;
  }
  // The finding with this number, of a slot or of a face of the file.
  Element element(std::uint32_t index) const {
    Element found;
    found.kind = sort();
    found.index = index;
    return found;
  }
  Text sentence(std::size_t count) const;
  // The name behind that number, as a part of a sentence.
  Text name_of(std::size_t count) const;
};

// Of a live element that is a member. Cost: the boundary edges for a loop, else the faces around it.
std::vector<Element> about(const ProblemRow& row, Neighbourhood& around, const IndexSet& members, Element element);

std::span<const ProblemRow> problem_table();
const ProblemRow& row_of(ProblemKind kind);
// By id; null when there is none.
const ProblemRow* find_problem_row(std::string_view id);

// Adds a row at the end of the table while it lives: for programs with kinds of their own, and for tests. What was
// asked of a mesh is made after and gone before it; no other thread reads the table when it comes and goes. The one
// made last goes first.
class ScopedProblem {
 public:
  explicit ScopedProblem(ProblemRow row);  // its kind is the next number
  ~ScopedProblem();
  ScopedProblem(const ScopedProblem&) = delete;
  ScopedProblem& operator=(const ScopedProblem&) = delete;

  const ProblemKind kind;
};

}  // namespace ryosen
