#include "ryosen/ops/rules/surgery.h"

#include <algorithm>

#include "ryosen/ops/rules/shares.h"

namespace ryosen {

Halfedge link_edge(Edit& edit, Vertex a, Halfedge into_a, Vertex b, Halfedge into_b) {
  const Mesh& m = edit.mesh();
  const Halfedge h = edit.add_edge(a, b), o = twin(h);
  edit.fresh(edge(h));
  const Halfedge after_a = into_a ? m.next(into_a) : h, after_b = into_b ? m.next(into_b) : o;
  edit.connect(into_a ? into_a : o, h);
  edit.connect(into_b ? into_b : h, o);
  if (into_a) edit.connect(o, after_a);
  if (into_b) edit.connect(h, after_b);
  if (m.is_isolated(a)) edit.set_halfedge(a, h);
  if (m.is_isolated(b)) edit.set_halfedge(b, o);
  return h;
}

void unlink_edge(Edit& edit, Halfedge h) {
  const Mesh& m = edit.mesh();
  const auto leave = [&](Halfedge out) {
    const Halfedge before = m.prev(out), after = m.next(twin(out));
    const Vertex v = m.from(out);
    const bool is_last = after == out;
    if (!is_last) edit.connect(before, after);
    if (m.halfedge(v) == out) edit.set_halfedge(v, is_last ? Halfedge() : after);
  };
  leave(h);
  leave(twin(h));
  edit.drop(edge(h));
}

Halfedge link_inside(Edit& edit, Halfedge into_a, Halfedge into_b) {
  const Mesh& m = edit.mesh();
  const Face f = m.face(into_a);
  const Halfedge at_a = m.next(into_a), at_b = m.next(into_b);
  const Halfedge h = link_edge(edit, m.to(into_a), into_a, m.to(into_b), into_b);
  edit.set_face(h, f);
  edit.set_face(twin(h), f);
  edit.derive(h, at_a, Derivation::copies);
  edit.derive(twin(h), at_b, Derivation::copies);
  return h;
}

std::vector<Halfedge> chain_from(const Mesh& m, Halfedge h) {
  std::vector<Halfedge> chain{h};
  while (has_two_edges(m, m.to(chain.back())) && m.next(chain.back()) != h) chain.push_back(m.next(chain.back()));
  return chain;
}

std::vector<Halfedge> chain_through(const Mesh& m, Halfedge h) {
  const std::vector<Halfedge> back = chain_from(m, twin(h));
  return chain_from(m, has_two_edges(m, m.to(back.back())) ? h : twin(back.back()));
}

std::vector<Vertex> inner_vertices(const Mesh& m, std::span<const Halfedge> chain) {
  std::vector<Vertex> inner;
  for (std::size_t i = 1; i < chain.size(); ++i) inner.push_back(m.from(chain[i]));
  return inner;
}

// The ends hold what they held: a halfedge of the chain has a face, so none of them stood for a gap.
Face unite_faces(Edit& edit, std::span<const Halfedge> chain) {
  const Mesh& m = edit.mesh();
  const Halfedge first = chain.front(), last = chain.back();
  const Face stays = std::min(m.face(first), m.face(twin(first)));
  const bool left_stays = m.face(first) == stays;
  const Halfedge inside = left_stays ? first : twin(first), outside = twin(inside);
  const Face goes = m.face(outside), both[] = {stays, goes};
  edit.unite<Face>(stays, both, [&] { return areas_of(m, both); });
  const std::uint32_t ring_inside = ring_of(m, inside), ring_outside = ring_of(m, outside);
  // The halfedge that replaces the chain in the loop of the remaining face.
  const Halfedge joined = left_stays ? m.next(twin(first)) : m.next(last);
  const Halfedge goes_start = m.halfedge(goes);
  for_each_loop(m, goes, [&](Halfedge start) { set_face_along(edit, start, stays); });
  if (ring_outside != no_index) edit.remove_ring(goes, ring_outside);
  if (ring_inside == no_index && ring_outside != no_index) {
    // The remaining face was inside the other one, whose outer loop becomes the common one.
    edit.set_halfedge(stays, goes_start);
    edit.add_ring(stays, joined);
  } else {
    for (Halfedge h : chain) replace_start(edit, stays, left_stays ? h : twin(h), joined);
    if (ring_outside != no_index) edit.add_ring(stays, goes_start);
  }
  move_rings(edit, goes, stays);
  for (Halfedge h : chain) unlink_edge(edit, h);
  edit.remove(goes);
  return goes;
}

void take_face_away(Edit& edit, Face f) {
  const Mesh& m = edit.mesh();
  for_each_loop(m, f, [&](Halfedge start) {
    set_face_along(edit, start, Face());
    for (Halfedge h : loop(m, start)) {
      if (!m.is_outside(m.halfedge(m.from(h)))) edit.set_halfedge(m.from(h), h);
      edit.fresh(h);
    }
  });
  while (m.has_rings(f)) edit.remove_ring(f, m.first_ring(f));
  edit.drop(f);
}

void fill_loop(Edit& edit, Halfedge start, Face f) {
  set_face_along(edit, start, f);
  for (const Halfedge h : loop(edit.mesh(), start)) edit.fresh(h);
}

void set_face_along(Edit& edit, Halfedge start, Face f) {
  for (Halfedge h : loop(edit.mesh(), start)) edit.set_face(h, f);
}

void hold_outside(Edit& edit, Vertex v) {
  const Mesh& m = edit.mesh();
  for (Halfedge h : outgoing(m, v))
    if (m.is_outside(h)) return edit.set_halfedge(v, h);
}

bool has_two_edges(const Mesh& mesh, Vertex v) {
  if (mesh.is_isolated(v)) return false;
  const Halfedge h = mesh.halfedge(v), other = mesh.counter_clockwise(h);
  return other != h && mesh.counter_clockwise(other) == h;
}

std::vector<Halfedge> gaps_at(const Mesh& mesh, Vertex v) {
  std::vector<Halfedge> gaps;
  for (Halfedge h : outgoing(mesh, v))
    if (mesh.is_outside(h)) gaps.push_back(mesh.prev(h));
  return gaps;
}

}  // namespace ryosen
