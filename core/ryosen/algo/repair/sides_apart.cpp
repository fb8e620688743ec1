#include "ryosen/algo/repair/sides_apart.h"

#include <utility>

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// All sides of faces between two places with an end at a point asked for, sorted.
std::vector<SideBetween> sides_between_places(const Mesh& m, const std::vector<Vertex>& place,
                                              const std::vector<bool>& is_asked) {
  std::vector<SideBetween> sides;
  for_each_side(m, [&](Halfedge h) {
    const Vertex from = place[m.from(h).index], to = place[m.to(h).index];
    const bool is_one = is_asked[point(m, m.from(h)).index] || is_asked[point(m, m.to(h)).index];
    if (from != to && is_one) sides.emplace_back(from, to, h);
  });
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

std::vector<SidePair> sides_at_one_place(const Mesh& m, const std::vector<Vertex>& place) {
  std::vector<bool> is_shared(m.vertex_slots(), false);
  bool is_any = false;
  for (const Vertex v : live_vertices(m))
    if (place[v.index] != point(m, v)) is_any = is_shared[point(m, v).index] = is_shared[place[v.index].index] = true;
  std::vector<SidePair> pairs;
  if (!is_any) return pairs;
  for_each_edge(sides_between_places(m, place, is_shared), [&](std::span<const SideBetween> sides) {
    if (sides.size() != 2) return;
    const Halfedge h = sides[0].halfedge, other = sides[1].halfedge;
    if (!m.is_outside(twin(h)) || !m.is_outside(twin(other))) return;
    const auto points = [&](Halfedge of) { return std::minmax({point(m, m.from(of)), point(m, m.to(of))}); };
    if (points(h) != points(other)) pairs.push_back({h, other, sides[0].is_forward == sides[1].is_forward});
  });
  return pairs;
}

std::vector<Halfedge> lone_sides(const Mesh& m, const std::vector<Vertex>& place) {
  std::vector<bool> is_at_boundary(m.vertex_slots(), false);
  for_each_side(m, [&](Halfedge h) {
    if (!m.is_outside(twin(h))) return;
    for (Vertex v : {m.from(h), m.to(h)}) is_at_boundary[point(m, v).index] = true;
  });
  std::vector<Halfedge> lone;
  for_each_edge(sides_between_places(m, place, is_at_boundary), [&](std::span<const SideBetween> sides) {
    const Halfedge h = sides[0].halfedge;
    if (sides.size() == 1 && m.is_outside(twin(h)) && is_finite(m.position(m.from(h))) &&
        is_finite(m.position(m.to(h))))
      lone.push_back(h);
  });
  std::sort(lone.begin(), lone.end());
  return lone;
}

std::vector<bool> turns_of(const Mesh& m, const std::vector<SidePair>& pairs) {
  if (std::none_of(pairs.begin(), pairs.end(), [](const SidePair& p) { return p.runs_alike; })) return {};
  const std::uint32_t n = m.face_slots();
  DisjointSets sets(2 * n);  // what is to be turned alike: faces as they are, and from n on the same ones turned
  const auto join = [&](Face f, Face g, bool turns) {
    const std::uint32_t alike = turns ? g.index + n : g.index, against = turns ? g.index : g.index + n;
    if (sets.root(f.index) == sets.root(against)) return;
    sets.join(f.index, alike);
    sets.join(f.index + n, against);
  };
  for (const Edge e : live_edges(m)) {
    const Halfedge h = halfedge(e);
    if (!m.is_outside(h) && !m.is_outside(twin(h))) join(m.face(h), m.face(twin(h)), false);
  }
  for (const bool turns : {false, true})  // where not all can agree, those that agree as they are come first
    for (const SidePair& pair : pairs)
      if (pair.runs_alike == turns) join(m.face(pair.first), m.face(pair.second), turns);
  // Which set a face is in, by the lowest face there, and whether it is against that one.
  const auto set_of = [&](std::uint32_t f) {
    const std::uint32_t own = sets.root(f), other = sets.root(f + n);
    return std::pair(std::min(own, other), other < own);
  };
  std::vector<std::uint32_t> faces(n, 0), against(n, 0);
  for (std::uint32_t f = 0; f < n; ++f) {
    const auto [set, is_against] = set_of(f);
    ++faces[set];
    against[set] += is_against;
  }
  std::vector<bool> turned(n);
  for (std::uint32_t f = 0; f < n; ++f) {
    const auto [set, is_against] = set_of(f);
    turned[f] = is_against != (2 * against[set] > faces[set]);  // the lowest face stays on a tie
  }
  return std::find(turned.begin(), turned.end(), true) == turned.end() ? std::vector<bool>() : turned;
}

}  // namespace ryosen
