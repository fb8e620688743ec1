#include "ryosen/algo/repair/flat_faces.h"

#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/rules/face_lists.h"

namespace ryosen {

namespace {

bool makes_flat(const Mesh& m, Halfedge h) {
  const Vertex goes = m.from(h), stays = m.to(h);
  const auto place = [&](Vertex v) { return m.position(v == goes ? stays : v); };
  for (Face f : faces_around(m, goes)) {
    if (!f) continue;
    const bool vanishes = (f == m.face(h) || f == m.face(twin(h))) && corner_count(m, f) == 3;
    if (!vanishes && !is_flat(m, f) && is_flat_at(m, f, place)) return true;
  }
  return false;
}

bool makes_hanging_pair(const Mesh& m, Halfedge h) {
  for (Halfedge side : {h, twin(h)})
    if (const Face f = m.face(side); f && corner_count(m, f) == 4 && equal_face(m, f)) return true;
  return false;
}

}  // namespace

bool collapses_soundly(const Mesh& m, Halfedge h) {
  const CollapseEdge op{h, CollapseEdge::Place::end};
  return !makes_flat(m, h) && !makes_hanging_pair(m, h) && op.is_legal(m) && op.directed(m) == h;
}

}  // namespace ryosen
