#include "ryosen/ops/euler/delete_edge.h"

#include <cassert>

#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

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
  OpEffect effect;
  effect.deleted.push_back(edge(halfedge));
  return effect;
}

}  // namespace ryosen
