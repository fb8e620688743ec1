#include "ryosen/algo/repair/sides_apart.h"

#include <algorithm>
#include <span>
#include <utility>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

struct SideAtPlace {
  Vertex low, high;  // places
  Halfedge halfedge;
  bool is_forward;
  friend auto operator<=>(const SideAtPlace&, const SideAtPlace&) = default;
};

// All sides of faces between two places with an end among the points asked for, sorted.
std::vector<SideAtPlace> sides_between_places(const Mesh& m, const std::vector<Vertex>& point_of,
                                              const std::vector<Vertex>& place, const std::vector<bool>& is_asked) {
  std::vector<SideAtPlace> sides;
  for (std::uint32_t i = 0; i < m.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!m.is_alive(h) || m.is_outside(h)) continue;
    const Vertex a = point_of[m.from(h).index], b = point_of[m.to(h).index];
    const Vertex from = place[a.index], to = place[b.index];
    if (from == to || (!is_asked[a.index] && !is_asked[b.index])) continue;
    sides.push_back({std::min(from, to), std::max(from, to), h, from < to});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Calls visit with all sides between the same two places.
template <class Visit>
void for_each_group(const std::vector<SideAtPlace>& sides, Visit visit) {
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high) ++last;
    visit(std::span(sides).subspan(first, last - first));
  }
}

// Sets of faces that are turned together or against each other.
class TurnedSets {
 public:
  explicit TurnedSets(std::uint32_t faces) : parent_(faces), is_against_(faces, false), size_(faces, 1) {
    for (std::uint32_t f = 0; f < faces; ++f) parent_[f] = f;
  }

  // Where the set of a face begins, and whether the face is against that one.
  std::pair<std::uint32_t, bool> find(std::uint32_t f) const {
    bool against = false;
    for (; parent_[f] != f; f = parent_[f]) against ^= is_against_[f];
    return {f, against};
  }
  void join(std::uint32_t f, std::uint32_t g, bool against) {
    auto [a, a_against] = find(f);
    auto [b, b_against] = find(g);
    if (a == b) return;
    if (size_[a] < size_[b] || (size_[a] == size_[b] && b < a)) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    is_against_[b] = against ^ a_against ^ b_against;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> is_against_;
  std::vector<std::uint32_t> size_;
};

}  // namespace

std::vector<SidePair> sides_at_one_place(const Mesh& m, const std::vector<Vertex>& point_of,
                                         const std::vector<Vertex>& place) {
  std::vector<bool> is_shared(m.vertex_slots(), false);
  bool is_any = false;
  for (Vertex p : point_of) {
    if (!p || place[p.index] == p) continue;
    is_shared[p.index] = is_shared[place[p.index].index] = is_any = true;
  }
  if (!is_any) return {};
  std::vector<SidePair> pairs;
  for_each_group(sides_between_places(m, point_of, place, is_shared), [&](std::span<const SideAtPlace> sides) {
    if (sides.size() != 2) return;
    const Halfedge h = sides[0].halfedge, other = sides[1].halfedge;
    if (!m.is_outside(twin(h)) || !m.is_outside(twin(other))) return;
    const auto points = [&](Halfedge of) {
      return std::minmax({point_of[m.from(of).index], point_of[m.to(of).index]});
    };
    if (points(h) != points(other)) pairs.push_back({h, other, sides[0].is_forward == sides[1].is_forward});
  });
  return pairs;
}

std::vector<Halfedge> lone_sides(const Mesh& m, const std::vector<Vertex>& point_of, const std::vector<Vertex>& place) {
  std::vector<bool> is_at_boundary(m.vertex_slots(), false);
  for (std::uint32_t i = 0; i < m.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!m.is_alive(h) || m.is_outside(h) || !m.is_outside(twin(h))) continue;
    for (Vertex v : {m.from(h), m.to(h)}) is_at_boundary[point_of[v.index].index] = true;
  }
  std::vector<Halfedge> lone;
  for_each_group(sides_between_places(m, point_of, place, is_at_boundary), [&](std::span<const SideAtPlace> sides) {
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
  TurnedSets sets(m.face_slots());
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
    const Halfedge h = halfedge(Edge(i));
    if (m.is_alive(h) && !m.is_outside(h) && !m.is_outside(twin(h)))
      sets.join(m.face(h).index, m.face(twin(h)).index, false);
  }
  for (const bool turns : {false, true})  // where not all can agree, those that agree as they are come first
    for (const SidePair& pair : pairs)
      if (pair.runs_alike == turns) sets.join(m.face(pair.first).index, m.face(pair.second).index, turns);
  // Per set how many are against its beginning; the fewer are turned.
  std::vector<std::uint32_t> faces(m.face_slots(), 0), against(m.face_slots(), 0);
  for (std::uint32_t f = 0; f < m.face_slots(); ++f) {
    if (!m.is_alive(Face(f))) continue;
    const auto [set, is_against] = sets.find(f);
    ++faces[set];
    against[set] += is_against;
  }
  std::vector<bool> turned(m.face_slots(), false), first_turns(m.face_slots(), false), is_met(m.face_slots(), false);
  bool is_any = false;
  for (std::uint32_t f = 0; f < m.face_slots(); ++f) {
    if (!m.is_alive(Face(f))) continue;
    const auto [set, is_against] = sets.find(f);
    if (!is_met[set]) {  // the lowest face stays on a tie
      is_met[set] = true;
      first_turns[set] = 2 * against[set] == faces[set] ? is_against : 2 * against[set] > faces[set];
    }
    turned[f] = is_against != first_turns[set];
    is_any = is_any || turned[f];
  }
  return is_any ? turned : std::vector<bool>();
}

}  // namespace ryosen
