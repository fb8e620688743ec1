#include "ryosen/ops/euler/remove_vertex.h"

#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter remove_vertex_parameters[] = {with_words(
    {"vertex", "Vertex", "頂点", "the isolated vertex", "孤立頂点"}, required(copy<&RemoveVertex::vertex>("vN")))};

}  // namespace

constinit const OpInfo RemoveVertex::info{.id = "remove_vertex",
                                          .name_en = "Remove vertex",
                                          .name_ja = "頂点消去",
                                          .line = {.lists = {remove_vertex_parameters}},
                                          .help_en = "removes an isolated vertex",
                                          .help_ja = "孤立頂点を取り除く",
                                          .target = OpTargetKind::vertex,
                                          .group = OpGroup::euler,
                                          .aliases = "kvs"};

Verdict RemoveVertex::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, vertex, verdict)) return verdict;
  if (!mesh.is_isolated(vertex)) verdict.refuse(Rule::has_edges, {vertex, edge(mesh.halfedge(vertex))});
  return verdict;
}

OpEffect RemoveVertex::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  leave_copies(edit, vertex);
  edit.drop(vertex);
  return {.deleted = {vertex}};
}

}  // namespace ryosen
