#include "ryosen/ops/preview/reach.h"

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

bool has_higher_valence(const Mesh& m, Vertex v, std::size_t most) {
  std::size_t valence = 0;
  return any_of_copies(m, v, [&](Vertex copy) {
    for ([[maybe_unused]] Halfedge h : outgoing(m, copy))
      if (++valence > most) return true;
    return false;
  });
}

bool is_longer_cycle(const Mesh& m, Halfedge h, std::size_t most) {
  std::size_t length = 0;
  for ([[maybe_unused]] Halfedge side : loop(m, h))
    if (++length > most) return true;
  return false;
}

}  // namespace

bool reaches_further(const Mesh& m, const AnyOp& op, std::size_t most) {
  const Halfedge h = halfedge_of(op);
  if (!is_there(m, h)) return false;
  if (is_longer_cycle(m, h, most) || is_longer_cycle(m, twin(h), most)) return true;
  return (std::holds_alternative<CollapseEdge>(op) || std::holds_alternative<ExtrudeEdges>(op)) &&
         (has_higher_valence(m, m.from(h), most) || has_higher_valence(m, m.to(h), most));
}

}  // namespace ryosen
