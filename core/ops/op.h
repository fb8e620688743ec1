// What all operators have in common: how one is described, parsed, judged and applied.
//
// An operator is a small struct with these members:
//   static constexpr OpInfo info;
//   static Parsed<Op> parse(const Mesh&, std::span<const std::string_view> arguments);   from a script line
//   static Op at(const Mesh&, const OpTarget&);           what a click on the target does
//   std::string command(const Mesh&) const;               the script line that does the same
//   Verdict check(const Mesh&) const;                      every broken rule, pure
//   std::vector<Reason> warnings(const Mesh&) const;       what is legal but doubtful; only asked when the check is legal
//   OpEffect apply(Edit&) const;                           the check must be legal
// In the line "changes" above an operator, V, E, F, H, S and G are the terms of the Euler–Poincaré sum, and B stands for
// B + W + I, all walks outside of the faces (analysis/euler_poincare.h): each as the kernel's elements give them.
// at, command and check take elements that are none, deleted or unknown to the mesh too, as an undo may leave them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/verdict.h"
#include "core/mesh/edit.h"
#include "core/mesh/names.h"

namespace ryosen {

// What a click hands to an operator. selection: the elements selected before, in their order, as script arguments. any:
// the vertex, edge or face that the pointer is on, whichever is picked; the other two are none.
enum class OpTargetKind { none, vertex, edge, face, selection, any };

// Whether an operator may change how many boundaries, wires, parts and handles there are (B, W, I, S, G), or nothing but
// V, E, F and H.
enum class Topology { may_change, kept };

struct OpInfo {
  std::string_view id;
  std::string_view name_en, name_ja;
  std::string_view syntax;  // arguments of the script line
  std::string_view help_en, help_ja;
  char key;  // selects the tool in the editor
  OpTargetKind target;
  std::string_view aliases = "";  // further ids, separated by blanks
  Topology topology = Topology::may_change;
};

// Whether an operator is a tool: it works on what is clicked.
constexpr bool is_tool(const OpInfo& info) {
  return info.target != OpTargetKind::none && info.target != OpTargetKind::selection;
}

// What the pointer is on, of the kind that the operator asks for: a halfedge and the place along it, 0 at its origin and
// 1 at its end, or a vertex or face.
struct OpTarget {
  Halfedge halfedge;
  double along = 0.5;
  Vertex vertex = {};
  Face face = {};
};

// A parsed operator, or why the line does not say one.
template <class Op>
struct Parsed {
  std::optional<Op> op;
  NameError error = NameError::none;
  Text sentence;
};

// What an operator did. `changed` holds the faces whose corners differ now, new ones included.
struct OpEffect {
  std::vector<Element> created;
  std::vector<Element> deleted;
  std::vector<Face> changed;
};

// Whether an element is one, has been there and has not been deleted.
template <class Handle>
bool is_there(const Mesh& mesh, Handle element) {
  return element && mesh.exists(element) && mesh.is_alive(element);
}

// Refuses what is spoken of when it is not there.
inline bool is_gone(const Mesh& mesh, Vertex v, Verdict& verdict) {
  if (is_there(mesh, v)) return false;
  verdict.refuse(Rule::deleted, {v});
  return true;
}
inline bool is_gone(const Mesh& mesh, Halfedge h, Verdict& verdict) {
  if (is_there(mesh, h)) return false;
  verdict.refuse(Rule::deleted, {edge(h)});
  return true;
}
inline bool is_gone(const Mesh& mesh, Face f, Verdict& verdict) {
  if (is_there(mesh, f)) return false;
  verdict.refuse(Rule::deleted, {f});
  return true;
}

// Reads the edge that an operator is about, and passes a failure on.
template <class Op>
std::optional<Halfedge> parse_edge_argument(const Mesh& mesh, std::span<const std::string_view> arguments,
                                            Parsed<Op>& out) {
  if (arguments.empty()) {
    out.error = NameError::malformed;
    out.sentence = {"an edge A-B is missing", "稜線 A-B の指定がありません"};
    return std::nullopt;
  }
  const Named<Halfedge> edge = find_edge(mesh, arguments[0]);
  if (edge.ok()) return edge.element;
  out.error = edge.error;
  out.sentence = edge.sentence;
  return std::nullopt;
}

// An argument that cannot be read, and what is expected in its place: in Japanese with its particle.
Text not_understood(std::string_view argument, const Text& expected);
// An argument that does not fit an operator's syntax, empty where it takes none.
Text not_of_syntax(std::string_view argument, std::string_view syntax);
Text argument_missing(std::string_view syntax);

template <class Op>
Parsed<Op> malformed_argument(std::string_view argument, const Text& expected) {
  return {std::nullopt, NameError::malformed, not_understood(argument, expected)};
}
template <class Op>
Parsed<Op> malformed_argument(std::string_view argument) {
  return {std::nullopt, NameError::malformed, not_of_syntax(argument, Op::info.syntax)};
}

// A finite number that takes up the whole text.
std::optional<double> parse_double(std::string_view text);
// The shortest decimal that reads back as the same double.
std::string format_double(double value);

}  // namespace ryosen
