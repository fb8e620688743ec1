// The list of operators. Menus, keys, scripts, the command line, previews and tests are generated from it; a new
// operator adds its include and a word here, its id to the rules that it can break (ryosen/base/reasons.cpp), and its
// random arguments for the tests (tests/support/core/random_ops.cpp), and a row in tests/property/laws_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ryosen/mesh/names.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/delete.h"
#include "ryosen/ops/detach.h"
#include "ryosen/ops/dissolve.h"
#include "ryosen/ops/euler/delete_edge.h"
#include "ryosen/ops/euler/delete_loop.h"
#include "ryosen/ops/euler/make_edge.h"
#include "ryosen/ops/euler/make_loop.h"
#include "ryosen/ops/euler/make_ring.h"
#include "ryosen/ops/euler/make_vertex.h"
#include "ryosen/ops/euler/move_vertex.h"
#include "ryosen/ops/euler/remove_vertex.h"
#include "ryosen/ops/euler/separate_edge.h"
#include "ryosen/ops/euler/separate_loop.h"
#include "ryosen/ops/euler/unite_edge.h"
#include "ryosen/ops/euler/unite_loop.h"
#include "ryosen/ops/euler/unite_ring.h"
#include "ryosen/ops/extrude.h"
#include "ryosen/ops/extrude_edges.h"
#include "ryosen/ops/fill.h"
#include "ryosen/ops/make_face.h"
#include "ryosen/ops/orient.h"
#include "ryosen/ops/parameters/op_line.h"
#include "ryosen/ops/poke.h"
#include "ryosen/ops/reverse.h"
#include "ryosen/ops/separate_fans.h"
#include "ryosen/ops/split_edge.h"
#include "ryosen/ops/swap_edge.h"
#include "ryosen/ops/triangulate.h"
#include "ryosen/ops/vertex_split.h"
#include "ryosen/ops/weld.h"

namespace ryosen {

using AnyOp = std::variant<CollapseEdge, SwapEdge, SplitEdge, Orient,
                           // Refining.
                           Poke, VertexSplit, Triangulate, Dissolve, Extrude, ExtrudeEdges,
                           // Deleting, filling, repairing.
                           Delete, Fill, MakeFace, Reverse, SeparateFans, Detach, Weld,
                           // The Euler operators of the source texts.
                           MakeVertex, RemoveVertex, MoveVertex, MakeEdge, DeleteEdge, MakeLoop, DeleteLoop,
                           SeparateLoop, UniteLoop, SeparateEdge, UniteEdge, MakeRing, UniteRing>;

// One row per operator, in the order above.
const std::vector<OpInfo>& all_ops();
// The id and the aliases of an operator, for "did you mean".
void add_ids(const OpInfo& info, std::vector<std::string>& ids);
// By id or by one of its aliases.
const OpInfo* find_op(std::string_view id);

// The groups of operators, as a window lists them, in the order of OpGroup.
struct OpGroupRow {
  OpGroup group;
  const char *en, *ja;
  const char *help_en, *help_ja;  // what its operators are for, in a sentence
  bool is_apart = false;          // a menu with operators of several groups has one of its own for these
};
std::span<const OpGroupRow> op_groups();

// An operator from a line, or why the line is none.
struct ParsedOp {
  std::optional<AnyOp> op;
  NameError error = NameError::none;
  Text sentence;
};
// Reads the arguments of a line, words or elements, for the operator with this id. The id must be in the list.
ParsedOp parse_op(const Mesh& mesh, std::string_view id, std::span<const OpArgument> arguments);
// The same from a whole line: the id and its arguments, separated by blanks. An unknown id is malformed.
ParsedOp parse_line(const Mesh& mesh, std::string_view line);
std::vector<std::string_view> split_words(std::string_view line);
// The fault of the arguments of the operator with this id, on any mesh; none if that depends on the mesh.
std::optional<Text> fault_of_arguments(std::string_view id, std::span<const OpArgument> arguments);
AnyOp op_at(const Mesh& mesh, std::string_view id, const OpTarget& target);

// Call the operator's own function of that name.
const OpInfo& info_of(const AnyOp& op);
Verdict check(const Mesh& mesh, const AnyOp& op);
// The same for many questions about one mesh.
Verdict check(const Mesh& mesh, const AnyOp& op, LocalFacts& known);
std::vector<Reason> warnings(const Mesh& mesh, const AnyOp& op);
OpEffect apply(Edit& edit, const AnyOp& op);
// The operator with the position that is dragged (OpDrag); it must have one.
AnyOp dragged(AnyOp op, const glm::dvec3& position);
// The halfedge that an operator on one edge is about; none for others.
Halfedge halfedge_of(const AnyOp& op);
// The script line that does the same; parse_line() reads it on the same mesh.
std::string command_of(const Mesh& mesh, const AnyOp& op);

// The fault of the values of a legal operator, as parse_line() says it of its line.
std::optional<Text> fault_of_values(const Mesh& mesh, const AnyOp& op);

}  // namespace ryosen
