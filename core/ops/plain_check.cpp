#include "core/ops/plain_check.h"

#include <array>

namespace ryosen {

namespace {

constexpr unsigned max_neighbours = 32;

// Whether the loop of h has three halves. prev(h) is about to be walked over, so this costs no further cache line.
bool is_three_loop(const HalfedgeLinks* links, Halfedge h) {
  return links[h.index].next == links[links[h.index].prev.index].prev;
}

// What a walk around an end saw, the other end aside.
struct Surroundings {
  std::uint32_t neighbours = 0;
  std::uint32_t gaps = 0;     // outside halfedges that leave it
  bool all_triangles = true;  // among its faces
};

// Walks around from(start) counter-clockwise and calls visit(number, neighbour) for all but to(start).
template <class Visit>
Surroundings walk_around(const HalfedgeLinks* links, Halfedge start, Visit visit) {
  Surroundings seen;
  Halfedge g = start;
  for (;;) {
    const HalfedgeLinks& at = links[g.index];
    const HalfedgeLinks& before = links[at.prev.index];
    const bool outside = at.face.is_none();
    seen.gaps += outside;
    seen.all_triangles &= outside | (at.next == before.prev);
    g = twin(at.prev);
    if (g == start || seen.neighbours == max_neighbours) return seen;
    visit(seen.neighbours++, before.from);
  }
}

bool has_copies(const Mesh& m, std::initializer_list<Vertex> vertices) {
  if (!m.has_copies()) return false;
  for (Vertex v : vertices)
    if (m.next_copy(v) != v) return true;
  return false;
}

// With boundary at both ends: the edge itself must be boundary, its triangle must keep another neighbour, and its
// outside loop must not be a hole of three edges.
bool may_join_boundary(const HalfedgeLinks* links, Halfedge h) {
  const Halfedge inside = links[h.index].face ? h : twin(h), outside = twin(inside);
  if (links[outside.index].face) return false;
  const HalfedgeLinks& at = links[inside.index];
  const bool apex_stays = links[twin(at.next).index].face || links[twin(at.prev).index].face;
  return apex_stays && !is_three_loop(links, outside);
}

}  // namespace

bool is_surely_legal_collapse(const Mesh& m, Halfedge h) {
  if (m.has_rings()) return false;
  const HalfedgeLinks* links = m.columns().halfedges.data();
  const Halfedge o = twin(h);
  const std::uint32_t triangles = (links[h.index].face ? 1 : 0) + (links[o.index].face ? 1 : 0);
  std::array<Vertex, max_neighbours> ring;
  const bool copies = m.has_copies();
  bool any_copy = copies && has_copies(m, {links[h.index].from, links[o.index].from});
  const Surroundings a = walk_around(links, h, [&](std::uint32_t i, Vertex v) {
    ring[i] = v;
    if (copies) any_copy |= m.next_copy(v) != v;
  });
  std::uint32_t common = 0;
  const Surroundings b = walk_around(links, o, [&](std::uint32_t, Vertex v) {
    for (std::uint32_t i = 0; i < a.neighbours; ++i) common += ring[i] == v;
    if (copies) any_copy |= m.next_copy(v) != v;
  });
  // The apexes are the only common neighbours; two ends without a neighbour but these would leave two equal triangles.
  if (common != triangles || triangles == 0 || (a.neighbours == 2 && b.neighbours == 2)) return false;
  if (any_copy || !a.all_triangles || !b.all_triangles) return false;
  if (a.neighbours == max_neighbours || b.neighbours == max_neighbours || a.gaps > 1 || b.gaps > 1) return false;
  return a.gaps == 0 || b.gaps == 0 || may_join_boundary(links, h);
}

bool is_surely_legal_swap(const Mesh& m, Halfedge h) {
  if (m.has_rings()) return false;
  const HalfedgeLinks* links = m.columns().halfedges.data();
  const Halfedge o = twin(h);
  const HalfedgeLinks &left = links[h.index], &right = links[o.index];
  if (!left.face || !right.face || left.face == right.face) return false;
  if (!is_three_loop(links, h) || !is_three_loop(links, o)) return false;
  const Vertex c = links[left.prev.index].from, d = links[right.prev.index].from;
  if (c == d || has_copies(m, {left.from, right.from, c, d})) return false;
  // A second face on the points of an old or a new one would need a second edge a-b or an edge c-d.
  bool joined = false;
  const Surroundings seen =
      walk_around(links, left.prev, [&](std::uint32_t, Vertex neighbour) { joined |= neighbour == d; });
  return !joined && seen.neighbours < max_neighbours;
}

}  // namespace ryosen
