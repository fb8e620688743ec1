#include "ryosen/ops/rules/plain_check.h"

#include <algorithm>
#include <array>

#include "ryosen/mesh/prefetch.h"

namespace ryosen {

namespace {

constexpr unsigned max_neighbours = 32;
constexpr unsigned steps_at_once = 4;

// Whether the loop of h has three halfedges. prev(h) is loaded next anyway, so this touches no extra cache line.
bool is_three_loop(const HalfedgeLinks* links, Halfedge h) {
  return links[h.index].next == links[links[h.index].prev.index].prev;
}

// A counter-clockwise walk around an end of an edge, starting with the edge. Two walks can be interleaved, so that
// their cache misses overlap.
class EndWalk {
 public:
  EndWalk(const HalfedgeLinks* links, Halfedge start) : links_(links), start_(start), at_(start) {}

  // Advances to the next halfedge; returns whether that is the start.
  bool step() {
    const HalfedgeLinks& at = links_[at_.index];
    const HalfedgeLinks& before = links_[at.prev.index];
    const bool outside = at.face.is_none();
    gaps_ += outside;
    odd_ |= !outside & (at.next != before.prev);
    ring_[count_++] = before.from.index;
    at_ = twin(at.prev);
    return at_ == start_;
  }
  bool is_full() const { return count_ == max_neighbours; }

  // After the last step: the neighbours in order, the other end of the edge last; the number of boundary halfedges;
  // whether some face is not a triangle.
  std::uint32_t valence() const { return count_; }
  Vertex neighbour(std::uint32_t i) const { return Vertex(ring_[i]); }
  const std::uint32_t* ring() const { return ring_.data(); }
  // Pads the ring after `count` neighbours with numbers that no vertex has.
  void end_ring(std::uint32_t count) { std::fill_n(ring_.begin() + count, ring_block, no_index); }
  std::uint32_t gaps() const { return gaps_; }
  bool is_odd() const { return odd_; }

 private:
  const HalfedgeLinks* links_;
  Halfedge start_, at_;
  std::uint32_t count_ = 0, gaps_ = 0;
  bool odd_ = false;
  std::array<std::uint32_t, max_neighbours + ring_block> ring_;
};

// Completes both walks; false if one exceeds max_neighbours.
bool finish(EndWalk& a, EndWalk& b) {
  for (;;) {
    const bool a_done = a.step(), b_done = b.step();
    if (a_done | b_done) {
      EndWalk& other = a_done ? b : a;
      for (bool done = a_done & b_done; !done; done = other.step())
        if (other.is_full()) return false;
      return true;
    }
    if (a.is_full()) return false;
  }
}

// The number of common neighbours, without the first `skipped` and the last 1 + `skipped` of each ring.
std::uint32_t common_neighbours(const EndWalk& a, EndWalk& b, std::uint32_t skipped) {
  b.end_ring(b.valence() - 1 - skipped);
  return count_common(a.ring() + skipped, a.valence() - 1 - 2 * skipped, b.ring() + skipped,
                      b.valence() - 1 - 2 * skipped);
}

bool any_copy(const Mesh& m, const EndWalk& walk) {
  for (std::uint32_t i = 0; i < walk.valence(); ++i)
    if (m.next_copy(walk.neighbour(i)) != walk.neighbour(i)) return true;
  return false;
}

bool has_copies(const Mesh& m, std::initializer_list<Vertex> vertices) {
  if (!m.has_copies()) return false;
  for (Vertex v : vertices)
    if (m.next_copy(v) != v) return true;
  return false;
}

// If both ends are on the boundary: the edge itself must be a boundary edge, its triangle must keep another neighbour,
// and its boundary loop must have more than three edges.
bool may_join_boundary(const HalfedgeLinks* links, Halfedge h) {
  const Halfedge inside = links[h.index].face ? h : twin(h), outside = twin(inside);
  if (!links[inside.index].face || links[outside.index].face) return false;
  const HalfedgeLinks& at = links[inside.index];
  const bool apex_stays = links[twin(at.next).index].face || links[twin(at.prev).index].face;
  return apex_stays && !is_three_loop(links, outside);
}

// Prefetches what apply() will touch, while the check walks.
void fetch_ends(const Mesh& m, const HalfedgeLinks& a, const HalfedgeLinks& b) {
  for (const HalfedgeLinks* side : {&a, &b}) {
    prefetch(m, side->from);
    prefetch(m, side->face);
  }
}

// The same for the triangles that vanish: their apexes and adjacent faces.
void fetch_apexes(const Mesh& m, Halfedge h) {
  for (Halfedge beyond : {twin(m.prev(h)), twin(m.next(twin(h)))}) {
    prefetch(m, m.face(beyond));
    prefetch(m, m.next(beyond));
    prefetch(m, m.prev(beyond));
  }
  prefetch(m, m.from(m.prev(h)));
  prefetch(m, m.from(m.prev(twin(h))));
}

}  // namespace

QuickAnswer quick_collapse(const Mesh& m, Halfedge h) {
  using enum QuickAnswer;
  if (m.has_rings()) return unknown;
  const HalfedgeLinks* links = m.columns().halfedges.data();
  const Halfedge o = twin(h);
  fetch_ends(m, links[h.index], links[o.index]);
  EndWalk a(links, h), b(links, o);
  if (!finish(a, b) || a.is_odd() | b.is_odd()) return unknown;
  fetch_apexes(m, h);
  if (m.has_copies() && (any_copy(m, a) || any_copy(m, b))) return unknown;
  if (a.gaps() + b.gaps() == 0 || (links[h.index].face && links[o.index].face)) {
    // An interior edge: the first and the last neighbour of each end are the apexes.
    if (!is_ordinary_inner_edge(a.gaps() + b.gaps(), a.valence(), b.valence())) return unknown;
    return common_neighbours(a, b, 1) == 0 ? legal : refused;
  }
  if (a.gaps() > 1 || b.gaps() > 1) return unknown;
  return common_neighbours(a, b, 0) == 1 && may_join_boundary(links, h) ? legal : unknown;
}

QuickAnswer quick_swap(const Mesh& m, Halfedge h) {
  using enum QuickAnswer;
  if (m.has_rings()) return unknown;
  const HalfedgeLinks* links = m.columns().halfedges.data();
  const Halfedge o = twin(h);
  const HalfedgeLinks &left = links[h.index], &right = links[o.index];
  if (!left.face || !right.face) return refused;
  if (left.face == right.face) return unknown;
  fetch_ends(m, left, right);
  prefetch(m, right.next);
  if (!is_three_loop(links, h) || !is_three_loop(links, o)) return unknown;
  const Vertex c = links[left.prev.index].from, d = links[right.prev.index].from;
  if (c == d || has_copies(m, {left.from, right.from, c, d})) return unknown;
  // A duplicate of an old or new face would need a second edge a-b or an edge c-d, so search the one-ring of c for d:
  // in both directions from the face at h until they meet. Walking further is harmless, so the exit test runs only
  // every few steps (branchless in between).
  Halfedge up = twin(left.next), down = left.prev;
  bool met = false, joined = false;
  for (unsigned steps = 0; steps < max_neighbours && !met; steps += steps_at_once) {
    for (unsigned i = 0; i < steps_at_once; ++i) {
      up = twin(links[up.index].prev);
      met |= up == down;
      down = links[twin(down).index].next;
      met |= up == down;
      joined |= (links[twin(up).index].from == d) | (links[twin(down).index].from == d);
    }
    if (joined) return refused;
  }
  return met ? legal : unknown;
}

}  // namespace ryosen
