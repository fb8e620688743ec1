#include "core/ops/euler/remove_vertex.h"

#include <cassert>

#include "core/mesh/copies.h"
#include "core/ops/lines/arguments.h"

namespace ryosen {

Parsed<RemoveVertex> RemoveVertex::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  const RemoveVertex op{in.vertex()};
  return in.result(op);
}

RemoveVertex RemoveVertex::at(const Mesh&, const OpTarget& target) { return {target.vertex}; }

std::string RemoveVertex::command(const Mesh& mesh) const { return "remove_vertex " + name_of_copy(mesh, vertex); }

Verdict RemoveVertex::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, vertex, verdict)) return verdict;
  if (!mesh.is_isolated(vertex)) verdict.refuse(Rule::has_edges, {vertex, edge(mesh.halfedge(vertex))});
  return verdict;
}

std::vector<Reason> RemoveVertex::warnings(const Mesh&) const { return {}; }

OpEffect RemoveVertex::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  leave_copies(edit, vertex);
  edit.remove(vertex);
  OpEffect effect;
  effect.deleted.push_back(vertex);
  return effect;
}

}  // namespace ryosen
