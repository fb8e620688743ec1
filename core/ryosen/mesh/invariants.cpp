#include "ryosen/mesh/invariants.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

using Broken = std::optional<BrokenInvariant>;

std::string name(Vertex v) { return "v" + std::to_string(v.index); }
std::string name(Halfedge h) { return "h" + std::to_string(h.index); }
std::string name(Face f) { return "f" + std::to_string(f.index); }

template <class Element>
BrokenInvariant broken(std::string rule, Element element, const std::string& sentence) {
  return {std::move(rule), name(element), name(element) + " " + sentence};
}

Broken check_lengths(const Mesh& m) {
  const MeshColumns& c = m.columns();
  const auto wrong = [](std::string what) { return BrokenInvariant{"column_length", "", std::move(what)}; };
  if (c.halfedges.size() % 2 != 0) return wrong("the number of halfedges is odd");
  if (c.positions.size() != c.vertex_halfedge.size()) return wrong("there is not one position per vertex");
  if (!c.next_copy.empty() && c.next_copy.size() != c.vertex_halfedge.size())
    return wrong("there is not one copy link per vertex");
  if (c.copy_point.size() != c.next_copy.size()) return wrong("there is not one point per copy link");
  if (!c.first_ring.empty() && c.first_ring.size() != c.face_halfedge.size())
    return wrong("there is not one chain of rings per face");
  for (const AttributeColumn& a : c.attributes) {
    const std::size_t words = a.words();
    if (words == 0 || a.fill.size() != words) return wrong("attribute " + a.name + " has no default of its type");
    const std::size_t elements = a.element == ElementKind::pool
                                     ? a.data.size() / words
                                     : length_of(a.element, m.vertex_slots(), m.halfedge_slots(), m.face_slots());
    if (a.data.size() != elements * words) return wrong("attribute " + a.name + " does not have one value per element");
  }
  return {};
}

bool is_live_link(const Mesh& m, Halfedge h) { return m.exists(h) && m.is_alive(h); }

Broken check_halfedge(const Mesh& m, Halfedge h) {
  const HalfedgeLinks& l = m.links(h);
  if (!m.exists(l.from) || !m.is_alive(l.from)) return broken("from", h, "begins at no live vertex");
  if (!is_live_link(m, l.next)) return broken("next", h, "has no live next halfedge");
  if (!is_live_link(m, l.prev)) return broken("prev", h, "has no live previous halfedge");
  if (m.prev(l.next) != h || m.next(l.prev) != h) return broken("next_prev", h, "is not the previous of its next");
  if (m.from(l.next) != m.to(h)) return broken("next_from", h, "ends where its next does not begin");
  if (m.from(h) == m.to(h)) return broken("loop_edge", h, "begins and ends at the same vertex");
  if (l.face != m.face(l.next)) return broken("face_along_loop", h, "and its next belong to different faces");
  if (l.face && (!m.exists(l.face) || !m.is_alive(l.face))) return broken("face", h, "belongs to no live face");
  return {};
}

Broken check_halfedges(const Mesh& m) {
  std::uint32_t live = 0;
  for (const Halfedge h : live_halfedges(m)) {
    ++live;
    if (Broken b = check_halfedge(m, h)) return b;
  }
  if (live != 2 * m.live().edges) return BrokenInvariant{"edge_count", "", "the count of live edges is wrong"};
  return {};
}

// Collects the starts of a face's rings; reports a chain that does not end or contains a dead ring.
Broken collect_rings(const Mesh& m, Face f, std::vector<bool>& seen, std::vector<Halfedge>& starts) {
  for (std::uint32_t r = m.first_ring(f); r != no_index; r = m.ring(r).next) {
    if (r >= seen.size() || seen[r]) return broken("ring_chain", f, "has a chain of rings that does not end");
    seen[r] = true;
    const Halfedge start = m.ring(r).halfedge;
    if (!is_live_link(m, start) || m.face(start) != f)
      return broken("ring_halfedge", f, "has a ring that is not its own");
    starts.push_back(start);
  }
  return {};
}

// With bridges removed, the loops of a face have three or more corners each and share no vertex. `last_face` is the
// last face seen at each vertex; only a face that visits a vertex twice can have bridges.
Broken check_loops(const Mesh& m, Face f, const std::vector<Halfedge>& starts, std::vector<Face>& last_face,
                   std::uint32_t& in_loops) {
  Vertex twice;
  CornerLoops loops;
  for (Halfedge start : starts) {
    std::uint32_t corners = 0;
    for (Halfedge h : loop(m, start)) {
      if (std::exchange(last_face[m.from(h).index], f) == f) twice = m.from(h);
      ++corners;
    }
    if (corners < 3) return broken("too_few_corners", f, "has a loop of fewer than three corners");
    in_loops += corners;
  }
  if (!twice) return {};
  for (Halfedge start : starts) {
    std::vector<std::uint32_t> corners;
    for (Halfedge h : loop(m, start)) corners.push_back(m.from(h).index);
    loops.add(corners);
  }
  if (!take_out_bridges(loops)) return broken("corner_twice", f, "visits " + name(twice) + " twice without a bridge");
  return {};
}

// Precondition: next is a permutation of the live halfedges, so loops close.
Broken check_faces(const Mesh& m) {
  std::uint32_t with_face = 0, in_loops = 0, live = 0, rings = 0;
  for (const Halfedge h : live_halfedges(m)) with_face += !m.is_outside(h);
  std::vector<Face> last_face(m.vertex_slots());
  std::vector<bool> seen_ring(m.columns().rings.size(), false);
  std::vector<Halfedge> starts;
  for (std::uint32_t i = 0; i < m.face_slots(); ++i) {
    const Face f(i);
    if (!m.is_alive(f)) {
      if (m.has_rings(f)) return broken("ring_of_dead", f, "is deleted but has rings");
      continue;
    }
    ++live;
    if (!is_live_link(m, m.halfedge(f)) || m.face(m.halfedge(f)) != f)
      return broken("face_halfedge", f, "holds no halfedge of its own");
    starts.assign(1, m.halfedge(f));
    if (Broken b = collect_rings(m, f, seen_ring, starts)) return b;
    rings += static_cast<std::uint32_t>(starts.size() - 1);
    if (Broken b = check_loops(m, f, starts, last_face, in_loops)) return b;
  }
  if (in_loops != with_face)
    return BrokenInvariant{"face_loops", "", "a face has a loop that is neither its outer one nor a ring"};
  if (live != m.live().faces) return BrokenInvariant{"face_count", "", "the count of live faces is wrong"};
  if (rings != m.live().rings) return BrokenInvariant{"ring_count", "", "the count of rings is wrong"};
  return {};
}

Broken check_vertex(const Mesh& m, Vertex v, std::uint32_t edges, std::vector<std::uint32_t>& last_neighbour) {
  const Halfedge start = m.halfedge(v);
  if (start.is_none())
    return edges == 0 ? Broken() : broken("vertex_halfedge", v, "holds no halfedge although edges begin at it");
  if (!is_live_link(m, start) || m.from(start) != v)
    return broken("vertex_halfedge", v, "holds no halfedge of its own");
  std::uint32_t seen = 0;
  bool has_gap = false;
  for (Halfedge h : outgoing(m, v)) {
    ++seen;
    has_gap |= m.is_outside(h);
    if (std::exchange(last_neighbour[m.to(h).index], v.index) == v.index)
      return broken("edge_twice", v, "and " + name(m.to(h)) + " are joined by two edges");
  }
  if (seen != edges) return broken("several_cycles", v, "has more than one cycle of halfedges");
  if (has_gap && !m.is_outside(start)) return broken("vertex_boundary", v, "does not hold its outside halfedge");
  return {};
}

// Precondition: twin(prev(h)) is a permutation of the live halfedges that preserves the origin, so the walks close.
Broken check_vertices(const Mesh& m) {
  std::vector<std::uint32_t> edges(m.vertex_slots(), 0);  // that begin at each
  for (const Halfedge h : live_halfedges(m)) ++edges[m.from(h).index];
  std::vector<std::uint32_t> last_neighbour(m.vertex_slots(), no_index);
  std::uint32_t live = 0;
  for (const Vertex v : live_vertices(m)) {
    ++live;
    if (Broken b = check_vertex(m, v, edges[v.index], last_neighbour)) return b;
  }
  if (live != m.live().vertices) return BrokenInvariant{"vertex_count", "", "the count of live vertices is wrong"};
  return {};
}

// Precondition: next_copy is a permutation, so lists close.
Broken check_points_of_copies(const Mesh& m) {
  std::vector<bool> visited(m.vertex_slots(), false);
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i) {
    if (visited[i]) continue;
    Vertex copy(i);  // ascending, so the first of a list is its smallest
    do {
      visited[copy.index] = true;
      if (m.copy_point(copy) != Vertex(i))
        return broken("copy_point", copy, "does not tell its point " + name(Vertex(i)));
      copy = m.next_copy(copy);
    } while (copy != Vertex(i));
  }
  return {};
}

Broken check_copies(const Mesh& m) {
  if (!m.has_copies()) return {};
  std::vector<bool> reached(m.vertex_slots(), false);
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i) {
    const Vertex v(i), next = m.next_copy(v);
    if (!m.is_alive(v)) {
      if (next != v) return broken("copy_of_dead", v, "is deleted but still a copy");
      continue;
    }
    if (!m.exists(next) || !m.is_alive(next)) return broken("copy", v, "has no live next copy");
    if (reached[next.index]) return broken("copy_cycle", next, "follows two copies");
    reached[next.index] = true;
    const glm::dvec3 &p = m.position(v), &q = m.position(next);
    if (std::memcmp(&p, &q, sizeof p) != 0) return broken("copy_position", v, "and its copy lie at different places");
  }
  return check_points_of_copies(m);
}

}  // namespace

std::optional<BrokenInvariant> check_invariants(const Mesh& mesh) {
  using Check = Broken (*)(const Mesh&);
  for (Check check : {&check_lengths, &check_halfedges, &check_faces, &check_vertices, &check_copies})
    if (Broken b = check(mesh)) return b;
  return {};
}

}  // namespace ryosen
