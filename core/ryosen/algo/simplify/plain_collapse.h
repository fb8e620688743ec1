// The collapse of an edge between triangles, for batch work: what collapse_edge.h does where nothing but triangles,
// each vertex with one fan at most, is around the edge and no corner carries values.
#pragma once

#include "ryosen/mesh/edit.h"

namespace ryosen {

// from(h) goes, to(h) stays where it is; the caller unites their values. quick_collapse(mesh, h) must have said legal.
// `take_over(stays, goes)` is told of each edge that goes for another one between the same points. Cost: the valence of
// the one that goes.
template <class TakeOver>
void plain_collapse(Edit& edit, Halfedge h, TakeOver take_over) {
  const Mesh& m = edit.mesh();
  const Halfedge o = twin(h);
  const Vertex gone = m.from(h), kept = m.to(h);
  const HalfedgeLinks left = m.links(h), right = m.links(o);
  const Halfedge left_going = left.face ? left.prev : Halfedge(), right_going = right.face ? right.next : Halfedge();
  const Halfedge first = m.counter_clockwise(h);
  Halfedge outside;  // that will leave the vertex that stays, of those that leave the other one
  for (Halfedge g = first; g != h;) {
    const Halfedge next = m.counter_clockwise(g);
    const bool goes = left.face && g == twin(left_going);
    if (m.is_outside(g)) outside = goes ? left.next : g;
    if (!goes && g != right_going) edit.set_from(g, kept);
    g = next;
  }
  // `going` ends or starts at the vertex that goes, `staying` takes the place of its twin.
  const auto close = [&](Halfedge going, Halfedge staying, Vertex apex, Face face) {
    const Halfedge beyond = twin(going);
    const HalfedgeLinks at = m.links(beyond);
    edit.derive(staying, beyond, Derivation::copies);
    edit.connect(at.prev, staying);
    edit.connect(staying, at.next);
    edit.set_face(staying, at.face);
    if (at.face && m.halfedge(at.face) == beyond) edit.set_halfedge(at.face, staying);
    const Halfedge from_apex = m.from(going) == apex ? going : beyond;
    if (m.halfedge(apex) == from_apex) edit.set_halfedge(apex, m.from(staying) == apex ? staying : twin(staying));
    take_over(edge(staying), edge(going));
    edit.derive(edge(staying), edge(staying), edge(going), 0.5, Derivation::unites);
    edit.remove(edge(going));
    edit.drop(face);
  };
  // Outside first: what goes may be all that follows there.
  if (!left.face) edit.connect(left.prev, left.next);
  if (!right.face) edit.connect(right.prev, right.next);
  const Vertex left_apex = left.face ? m.from(left.prev) : Vertex(),
               right_apex = right.face ? m.from(right.prev) : Vertex();
  if (left.face) close(left.prev, left.next, left_apex, left.face);
  if (right.face) close(right.next, right.prev, right_apex, right.face);
  // The vertex that stays stores a boundary halfedge, if it has one.
  Halfedge hold = m.halfedge(kept);
  if (hold == o || !m.is_alive(hold)) hold = left.face ? left.next : m.next(left.prev);
  if (outside && !m.is_outside(hold)) hold = outside;
  edit.set_halfedge(kept, hold);
  edit.drop(edge(h));
  edit.remove(gone);
}

}  // namespace ryosen
