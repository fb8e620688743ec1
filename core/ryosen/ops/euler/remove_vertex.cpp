#include "ryosen/ops/euler/remove_vertex.h"

#include <cassert>

#include "ryosen/mesh/copies.h"

namespace ryosen {

std::string RemoveVertex::command(const Mesh& mesh) const { return "remove_vertex " + name_of_copy(mesh, vertex); }

Verdict RemoveVertex::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, vertex, verdict)) return verdict;
  if (!mesh.is_isolated(vertex)) verdict.refuse(Rule::has_edges, {vertex, edge(mesh.halfedge(vertex))});
  return verdict;
}

OpEffect RemoveVertex::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  leave_copies(edit, vertex);
  edit.remove(vertex);
  OpEffect effect;
  effect.deleted.push_back(vertex);
  return effect;
}

}  // namespace ryosen
