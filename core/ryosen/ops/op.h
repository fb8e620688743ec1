// The operator concept: how an operator is described, parsed, checked and applied.
//
// An operator is a small struct with these members:
//   static const OpInfo info;                              its row, with the parameters of its line
//   static Op at(const Mesh&, const OpTarget&);           what a click on the target does
//   Verdict check(const Mesh&) const;                      every broken rule, pure
//   std::vector<Reason> warnings(const Mesh&) const;       what is legal but doubtful; asked only of what is legal
//   OpEffect apply(Edit&) const;                           the check must be legal
// at and check also accept elements that are none, deleted or out of range, as an undo may leave them, and so does the
// printing of its line. One that acts on a single vertex, halfedge or face gets at and warnings from a base (below).
//
// The comment above an operator gives its effect on the polygon list (wires are pairs), its preconditions, what it
// changes, and its inverse. In the line "changes" V, E, F, H, S and G are the terms of the Euler-Poincare sum, and B
// stands for B + W + I, all walks outside of the faces (analysis/euler_poincare.h): each as the kernel's elements give
// them. tests/property/laws_test.cpp has a row for each such line and each inverse.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/base/verdict.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/parameters/op_parameter.h"

namespace ryosen {

// What a click passes to an operator. selection: the selected elements, in order, as script arguments. any: the vertex,
// edge or face under the pointer, whichever is picked; the other two are none.
enum class OpTargetKind { none, vertex, edge, face, selection, any };

// What an operator is for (op_groups, all.h).
enum class OpGroup { refine, join, fill, orient, euler };

// Whether an operator may change how many boundaries, wires, parts and handles there are (B, W, I, S, G), or nothing
// but V, E, F and H.
enum class Topology { may_change, kept };

// What a question about an edge is really about: the edge itself, all sheets from one point to the other (a bridge for
// itself), or the cycle at its boundary halfedge. Edges with the same subject have the same verdict and the same
// warnings, but for reasons that name the edge. Along a cycle reasons come in the order from the edge.
enum class Subject { edge, points, cycle };

// How the elements of a selection become arguments: one call for each of them (each.h), one call with all of them in
// their order, or one for each but the last, with the last before it.
enum class OnSelection { none, each, all, into_last };

// What an operator works on where too little of a selection is what it takes: elements that belong to the selected
// ones.
struct InPlaceOf {
  std::vector<Element> (*elements)(const Mesh& mesh, std::span<const Element> selected);
  std::string_view en, ja;  // what may be selected for that: "faces side by side"
};

class OpSeries;

struct OpInfo {
  std::string_view id;
  std::string_view name_en, name_ja;
  OpLine line = {};
  std::string_view help_en, help_ja;
  char key = '\0';  // selects the tool in the editor
  OpTargetKind target;
  OpGroup group;
  std::string_view aliases = "";  // further ids, separated by spaces
  Topology topology = Topology::may_change;
  Subject subject = Subject::edge;
  OnSelection on_selection = OnSelection::each;
  const InPlaceOf* in_place_of = nullptr;
  // With into_last: the operator that does the same where an edge joins the two.
  std::string_view along_edge = "";
  // Many calls one after another, where that costs less than each by itself (op_series.h).
  std::unique_ptr<OpSeries> (*in_series)(Edit&) = nullptr;
  // Of a selection of edges: their ends go too that it has left with two edges, where unite_edge may take them out.
  bool takes_ends_along = false;
  // Where a selection is not told by how many of its elements it was done to: what each call has made, as count_text()
  // has it.
  struct Made {
    std::string_view en_one = "", en_many = "", ja = "";
  } made = {};
};

// Whether an operator is a tool, which acts on the clicked element.
constexpr bool is_tool(const OpInfo& info) {
  return info.target != OpTargetKind::none && info.target != OpTargetKind::selection;
}

// The element under the pointer, of the kind that the operator requires: a halfedge and the parameter along it, 0 at
// its origin and 1 at its end, or a vertex or face.
struct OpTarget {
  Halfedge halfedge;
  double along = 0.5;
  Vertex vertex = {};
  Face face = {};
  bool is_free = false;   // no snapping along the edge
  bool is_small = false;  // on the screen; the thirds of the edge are not told apart

  // The parameter to put something at: the middle from near by, else the nearest tenth; where free, of a thousand.
  double snapped_along() const {
    constexpr double near_middle = 0.08;
    const double parts = is_free ? 1000 : 10;
    if (!is_free && std::abs(along - 0.5) < near_middle) return 0.5;
    return std::clamp(std::round(along * parts), 1.0, parts - 1) / parts;
  }
};

// What an operator did. `changed` holds the faces whose corners changed, including new ones.
struct OpEffect {
  std::vector<Element> created = {};
  std::vector<Element> deleted = {};
  std::vector<Face> changed = {};
};

// Whether an element is not none, in range and alive.
template <class Handle>
bool is_there(const Mesh& mesh, Handle element) {
  return element && mesh.exists(element) && mesh.is_alive(element);
}

// Refuses an element that is not there.
template <class Handle>
bool is_gone(const Mesh& mesh, Handle element, Verdict& verdict) {
  if (is_there(mesh, element)) return false;
  if constexpr (std::is_same_v<Handle, Halfedge>)
    verdict.refuse(Rule::deleted, {edge(element)});
  else
    verdict.refuse(Rule::deleted, {element});
  return true;
}

// The same for a list: refuses an empty one, else the first that is not there.
template <class Handle>
bool any_is_gone(const Mesh& mesh, const std::vector<Handle>& elements, Verdict& verdict) {
  using Named = std::conditional_t<std::is_same_v<Handle, Halfedge>, Edge, Handle>;
  if (elements.empty()) verdict.refuse(Rule::deleted, {Named()});
  return elements.empty() ||
         std::any_of(elements.begin(), elements.end(), [&](Handle e) { return is_gone(mesh, e, verdict); });
}

// The rule of the first reason against an operator, if there is any.
inline std::optional<Rule> first_rule_of(const Verdict& verdict) {
  return verdict.legal() ? std::nullopt : std::optional(verdict.reasons[0].rule);
}

// The side of an edge for an operator on what is outside of faces: where the given one has a face, the other one.
inline Halfedge outside_side(const Mesh& mesh, Halfedge h) {
  return is_there(mesh, h) && !mesh.is_outside(h) ? twin(h) : h;
}

// Bases of the operators that act on one element and are told nothing else: the element, and what a click on it means.
// Such an operator adds its row, check() and apply(), its warnings() if it has any, and what differs.
template <class Op>
struct OnVertex {
  Vertex vertex;

  static Op at(const Mesh&, const OpTarget& target) { return {{target.vertex}}; }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  bool operator==(const OnVertex&) const = default;
};

template <class Op>
struct OnHalfedge {
  Halfedge halfedge;

  static Op at(const Mesh&, const OpTarget& target) { return {{target.halfedge}}; }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  bool operator==(const OnHalfedge&) const = default;
};

template <class Op>
struct OnFace {
  Face face;

  static Op at(const Mesh&, const OpTarget& target) { return {{target.face}}; }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  bool operator==(const OnFace&) const = default;
};

}  // namespace ryosen
