#include "ryosen/ops/euler/delete_edge.h"

#include <cassert>

#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter delete_edge_parameters[] = {with_words(
    {"edge", "Edge", "稜線", "the edge without a face", "面のない稜線"}, required(edge<&DeleteEdge::halfedge>("A-B")))};

}  // namespace

constinit const OpInfo DeleteEdge::info{.id = "delete_edge",
                                        .name_en = "Delete edge",
                                        .name_ja = "稜線消去",
                                        .line = {.lists = {delete_edge_parameters}},
                                        .help_en = "takes away an edge that has no face",
                                        .help_ja = "面を持たない稜線を取り除く",
                                        .target = OpTargetKind::edge,
                                        .group = OpGroup::euler};

Verdict DeleteEdge::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  for (Halfedge side : {halfedge, twin(halfedge)})
    if (!mesh.is_outside(side)) verdict.refuse(Rule::has_face, {edge(side), mesh.face(side)});
  return verdict;
}

OpEffect DeleteEdge::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  const Vertex ends[] = {edit.mesh().from(halfedge), edit.mesh().to(halfedge)};
  unlink_edge(edit, halfedge);
  for (Vertex v : ends) hold_outside(edit, v);
  return {.deleted = {edge(halfedge)}};
}

}  // namespace ryosen
