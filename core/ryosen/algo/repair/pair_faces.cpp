#include "ryosen/algo/repair/pair_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_set>

#include "ryosen/algo/repair/fan_groups.h"
#include "ryosen/algo/repair/point_merger.h"
#include "ryosen/algo/repair/sides_apart.h"
#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// An edge of three or more faces, and by direction how many of its faces are not free, its ranks and the first of these
// that may be free.
struct ManyFaced {
  std::vector<Halfedge> sides;
  std::array<std::size_t, 2> count{};
  std::array<std::vector<std::uint32_t>, 2> ranks;
  std::array<std::size_t, 2> cursor{};
};

// Pairs the sides of faces around edges. The mesh, `place`, which has by vertex slot the one that stands for its place,
// and `across`, which has the pairs known so far by halfedge slot, must outlive it.
class EdgePairer {
 public:
  EdgePairer(const Mesh& mesh, const std::vector<Vertex>& place, std::vector<Halfedge>& across)
      : mesh_(mesh), place_(place), across_(across) {}

  // All sides run between the same two places, as many in each direction. Around the edge a face is paired with the
  // first face of the other direction through its inside, which lies behind it, opposite its normal. Where faces lie at
  // one angle, a face that ends an inside comes before one that begins one, and then the lowest face is the nearest.
  // Exact. Cost: O(k log k) for k sides, and a triangulation of the faces that are no triangles.
  void pair(std::span<const Halfedge> sides) {
    const Vertex from = mesh_.from(sides[0]);
    const glm::dvec3 start = mesh_.position(from), end = mesh_.position(mesh_.to(sides[0]));
    std::vector<SideAround> around;
    for (const Halfedge side : sides)
      around.push_back({side, mesh_.face(side), place_[mesh_.from(side).index] != place_[from.index],
                        place_beside(side, start, end)});
    std::sort(around.begin(), around.end(), [](const SideAround& a, const SideAround& b) {
      return a.face != b.face ? a.face < b.face : a.side < b.side;
    });
    const auto first =
        std::find_if(around.begin(), around.end(), [](const SideAround& s) { return s.place.has_value(); });
    std::optional<AroundEdge> order;  // none where no face has a place
    const glm::dvec3 place = first != around.end() ? *first->place : start;
    if (first != around.end()) order.emplace(start, end, place);
    const auto compare = [&](const SideAround& a, const SideAround& b) {
      return order ? order->compare(a.place.value_or(place), b.place.value_or(place)) : 0;
    };
    std::stable_sort(around.begin(), around.end(),
                     [&](const SideAround& a, const SideAround& b) { return compare(a, b) < 0; });
    for (auto begin = around.begin(), next = begin; begin != around.end(); begin = next) {
      next = std::find_if(begin, around.end(), [&](const SideAround& s) { return compare(*begin, s) != 0; });
      // Of those at one angle, which ascend by face: those that end an inside first, the lowest face nearest to it.
      std::reverse(std::stable_partition(begin, next, [](const SideAround& s) { return !s.begins; }), next);
    }
    match(around);
  }

 private:
  struct SideAround {
    Halfedge side;
    Face face;
    bool begins;  // an inside, counter-clockwise around the edge
    std::optional<glm::dvec3> place;
  };

  void triangulate(Face f) {
    if (!triangulated_.insert(f).second) return;
    const FacePolygon polygon(mesh_, f);
    if (!polygon.is_finite()) return;
    const std::vector<Halfedge>& corners = polygon.corners();
    std::vector<CornerTriangle> triangles;
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0);
    if (polygon.loop_ends().size() == 1) {
      make_canonical(order, corners);
      std::vector<glm::dvec3> places;
      for (const std::uint32_t i : order) places.push_back(polygon.places()[i]);
      ryosen::triangulate(places, triangles);
    } else {
      polygon.triangulate(triangles);
    }
    for (const CornerTriangle& triangle : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = order[triangle[i]], b = order[triangle[(i + 1) % 3]], c = order[triangle[(i + 2) % 3]];
        if (polygon.is_side(a, b)) apexes_.try_emplace(corners[a], polygon.places()[c]);
        if (polygon.is_side(b, a)) apexes_.try_emplace(corners[b], polygon.places()[c]);
      }
  }

  // Puts the corners of a polygon, given from 0 on, in an order that depends neither on its start nor on its direction,
  // so that two faces back to back have the same triangles.
  void make_canonical(std::vector<std::uint32_t>& order, const std::vector<Halfedge>& corners) const {
    const auto number = [&](std::uint32_t i) { return place_[mesh_.from(corners[i]).index].index; };
    const auto lowest = std::min_element(order.begin(), order.end(),
                                         [&](std::uint32_t a, std::uint32_t b) { return number(a) < number(b); });
    std::rotate(order.begin(), lowest, order.end());
    if (number(order.back()) < number(order[1])) std::reverse(order.begin() + 1, order.end());
  }

  // A corner of the face that lies beside the side as seen within the face; none where it is not finite.
  std::optional<glm::dvec3> apex(Halfedge side) {
    if (is_triangle(mesh_, side) && !mesh_.has_rings(mesh_.face(side))) {
      const glm::dvec3 place = mesh_.position(mesh_.from(mesh_.prev(side)));
      return is_finite(place) ? std::optional(place) : std::nullopt;
    }
    triangulate(mesh_.face(side));
    const auto found = apexes_.find(side);
    return found == apexes_.end() ? std::nullopt : std::optional(found->second);
  }

  // A place off the edge's line in the direction of the face. A face without area there has that of a neighbour across
  // it.
  std::optional<glm::dvec3> place_beside(Halfedge side, const glm::dvec3& start, const glm::dvec3& end) {
    constexpr std::size_t most_faces = 16;
    if (!is_finite(start) || !is_finite(end)) return std::nullopt;
    std::vector<Halfedge> entered{side};
    for (std::size_t i = 0; i < entered.size(); ++i) {
      const std::optional<glm::dvec3> place = apex(entered[i]);
      if (place && !are_collinear(start, end, *place)) return place;
      for (const Halfedge h : halfedges_around(mesh_, mesh_.face(entered[i]))) {
        const Halfedge next = across_[h.index];
        if (!next || h == entered[i] || entered.size() >= most_faces) continue;
        if (std::none_of(entered.begin(), entered.end(), [&](Halfedge e) { return mesh_.face(e) == mesh_.face(next); }))
          entered.push_back(next);
      }
    }
    return std::nullopt;
  }

  // As brackets are matched, going on from the end at the beginning.
  void match(std::span<const SideAround> around) {
    std::vector<Halfedge> open, ends;
    const auto join = [&](Halfedge closing) {
      across_[open.back().index] = closing;
      across_[closing.index] = open.back();
      open.pop_back();
    };
    for (const SideAround& s : around) {
      if (s.begins)
        open.push_back(s.side);
      else if (open.empty())
        ends.push_back(s.side);
      else
        join(s.side);
    }
    for (const Halfedge closing : ends) join(closing);
  }

  const Mesh& mesh_;
  const std::vector<Vertex>& place_;
  std::vector<Halfedge>& across_;
  std::unordered_set<Face> triangulated_;
  std::unordered_map<Halfedge, glm::dvec3> apexes_;  // by side, of the triangle at it
};

class Pairing {
 public:
  // `place` has the place of each vertex by its slot; `keeps_joined`: faces that are joined may stay so.
  Pairing(const Mesh& mesh, const std::vector<Vertex>& place, bool keeps_joined)
      : m_(mesh),
        place_(place),
        keeps_joined_(keeps_joined),
        is_shared_(mesh.vertex_slots(), false),
        patches_(mesh.face_slots()),
        has_boundary_(mesh.face_slots(), false) {
    out_.across.resize(mesh.halfedge_slots());
    out_.is_free.resize(mesh.face_slots(), false);
  }

  FacePairing run() {
    find_shared_places();
    pair_at_plain_edges();
    pair_at_shared_places();
    out_.has_nonmanifold_edges = !edges_.empty();
    out_.open_sides = at_boundary_.size();
    if (!edges_.empty()) {
      set_patches_free();
      pair_by_angle();
      if (keeps_joined_) keep_edges_single();
    }
    find_parts();
    return std::move(out_);
  }

 private:
  void pair(Halfedge h, Halfedge other) {
    out_.across[h.index] = other;
    out_.across[other.index] = h;
    patches_.join(m_.face(h).index, m_.face(other).index);
  }

  void find_shared_places() {
    std::vector<Vertex> first(m_.vertex_slots());  // by place
    for (const Vertex v : live_vertices(m_)) {
      Vertex& known = first[place_[v.index].index];
      if (!known)
        known = v;
      else
        is_shared_[known.index] = is_shared_[v.index] = true;
    }
  }

  // Where no end shares its place an edge has the faces that its links say.
  void pair_at_plain_edges() {
    for_each_side(m_, [&](Halfedge h) {
      const Vertex from = m_.from(h), to = m_.to(h);
      const bool is_joined = !m_.is_outside(twin(h));
      if ((is_shared_[from.index] || is_shared_[to.index]) && !(keeps_joined_ && is_joined)) {
        const SideBetween side(place_[from.index], place_[to.index], h);
        if (side.low != side.high) sides_.push_back(side);
      } else if (is_joined) {
        pair(h, twin(h));
      } else {
        at_boundary_.push_back(m_.face(h));
      }
    });
  }

  void pair_at_shared_places() {
    std::sort(sides_.begin(), sides_.end());
    for_each_edge(sides_, [&](std::span<const SideBetween> sides) {
      if (sides.size() == 1) at_boundary_.push_back(m_.face(sides[0].halfedge));
      if (sides.size() == 2 && sides[0].is_forward != sides[1].is_forward) pair(sides[0].halfedge, sides[1].halfedge);
      if (sides.size() <= 2) return;
      ManyFaced& edge = edges_.emplace_back();
      for (const SideBetween& side : sides) {
        edge.sides.push_back(side.halfedge);
        ++edge.count[side.is_forward];
      }
    });
    for (const Face f : at_boundary_) has_boundary_[patches_.root(f.index)] = true;
  }

  std::uint32_t patch(Halfedge side) { return patches_.root(m_.face(side).index); }
  bool is_forward(Halfedge side) const { return place_[m_.from(side).index] < place_[m_.to(side).index]; }

  // The rank of each patch in the order in which patches are set free.
  std::vector<std::uint32_t> rank_patches() {
    std::vector<double> areas(m_.face_slots(), 0);
    std::vector<std::uint32_t> order;
    for (const Face f : live_faces(m_)) {
      const std::uint32_t patch = patches_.root(f.index);
      areas[patch] += face_area(m_, f);
      if (patch == f.index) order.push_back(patch);
    }
    for (double& area : areas)
      if (std::isnan(area)) area = std::numeric_limits<double>::infinity();
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tuple(!has_boundary_[a], areas[a], a) < std::tuple(!has_boundary_[b], areas[b], b);
    });
    std::vector<std::uint32_t> ranks(m_.face_slots(), no_index);
    for (std::uint32_t i = 0; i < order.size(); ++i) ranks[order[i]] = i;
    return ranks;
  }

  // The rank of the patch that goes first from an edge, or none while its directions are even.
  std::uint32_t first_to_go(ManyFaced& edge) {
    if (edge.count[0] == edge.count[1]) return no_index;
    const std::size_t direction = edge.count[1] > edge.count[0];
    std::size_t& at = edge.cursor[direction];
    while (is_free_[edge.ranks[direction][at]]) ++at;
    return edge.ranks[direction][at];
  }

  void set_patches_free() {
    using Wanted = std::pair<std::uint32_t, std::uint32_t>;  // rank, edge
    const std::vector<std::uint32_t> rank = rank_patches();
    is_free_.assign(m_.face_slots(), false);
    std::vector<std::pair<std::uint32_t, std::pair<std::uint32_t, bool>>> sides;  // rank, edge and direction
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      for (const Halfedge h : edges_[e].sides) {
        const std::uint32_t r = rank[patch(h)];
        edges_[e].ranks[is_forward(h)].push_back(r);
        sides.push_back({r, {e, is_forward(h)}});
      }
      for (auto& ranks : edges_[e].ranks) std::sort(ranks.begin(), ranks.end());
    }
    std::sort(sides.begin(), sides.end());
    std::priority_queue<Wanted, std::vector<Wanted>, std::greater<>> queue;
    const auto ask = [&](std::uint32_t e) {
      if (const std::uint32_t r = first_to_go(edges_[e]); r != no_index) queue.push({r, e});
    };
    for (std::uint32_t e = 0; e < edges_.size(); ++e) ask(e);
    while (!queue.empty()) {
      const auto [r, e] = queue.top();
      queue.pop();
      if (const std::uint32_t now = first_to_go(edges_[e]); now != r) {
        if (now != no_index) queue.push({now, e});
        continue;
      }
      is_free_[r] = true;
      const auto first = std::lower_bound(sides.begin(), sides.end(), std::pair(r, std::pair(0u, false)));
      for (auto side = first; side != sides.end() && side->first == r; ++side)
        --edges_[side->second.first].count[side->second.second];
      for (auto side = first; side != sides.end() && side->first == r; ++side) ask(side->second.first);
    }
    for (const Face f : live_faces(m_)) out_.is_free[f.index] = is_free_[rank[patches_.root(f.index)]];
  }

  void pair_by_angle() {
    EdgePairer pairer(m_, place_, out_.across);
    for (const ManyFaced& edge : edges_) {
      std::vector<Halfedge> sides = edge.sides;
      out_.open_sides += std::erase_if(sides, [&](Halfedge h) { return out_.is_free[m_.face(h).index]; });
      if (!sides.empty()) pairer.pair(sides);
    }
  }

  // Exchanges pairs where two vertices would have two edges.
  void keep_edges_single() {
    std::vector<bool> is_end(m_.vertex_slots(), false);  // by place
    std::vector<std::vector<Halfedge>> edges;
    for (ManyFaced& edge : edges_) {
      for (const Vertex v : {m_.from(edge.sides[0]), m_.to(edge.sides[0])}) is_end[place_[v.index].index] = true;
      edges.push_back(std::move(edge.sides));
    }
    FanGroups fans(m_, &place_);
    for_each_side(m_, [&](Halfedge corner) {
      if (!is_end[place_[m_.from(corner).index].index]) return;
      fans.add_corner(corner);
      for (const Halfedge side : {corner, m_.prev(corner)}) fans.add_side(side, out_.across[side.index]);
    });
    fans.find_fans(edges);
    for (const std::vector<Halfedge>& sides : edges)
      for (const Halfedge side : sides) out_.across[side.index] = fans.across(side);
  }

  void find_parts() {
    DisjointSets parts(m_.face_slots());
    for (std::uint32_t i = 0; i < m_.halfedge_slots(); ++i)
      if (const Halfedge other = out_.across[i]) parts.join(m_.face(Halfedge(i)).index, m_.face(other).index);
    std::vector<bool> is_open(m_.face_slots(), false);
    for_each_side(m_, [&](Halfedge h) {
      if (!out_.across[h.index]) is_open[parts.root(m_.face(h).index)] = true;
    });
    out_.part.resize(m_.face_slots());
    out_.is_closed.resize(m_.face_slots());
    for (std::uint32_t f = 0; f < m_.face_slots(); ++f) {
      out_.part[f] = parts.root(f);
      out_.is_closed[f] = m_.is_alive(Face(f)) && !is_open[out_.part[f]];
    }
  }

  const Mesh& m_;
  const std::vector<Vertex>& place_;
  const bool keeps_joined_;
  std::vector<bool> is_shared_;  // whether another vertex is at the vertex's place
  FacePairing out_;
  DisjointSets patches_;
  std::vector<bool> has_boundary_;  // by patch
  std::vector<Face> at_boundary_;
  std::vector<SideBetween> sides_;  // at places of several vertices
  std::vector<ManyFaced> edges_;
  std::vector<bool> is_free_;  // by rank
};

}  // namespace

FacePairing pair_faces(const Mesh& mesh) { return Pairing(mesh, points_by_slot(mesh), false).run(); }

FacePairing pair_at_places(const Mesh& mesh, const std::vector<Vertex>& place) {
  return Pairing(mesh, place, true).run();
}

bool is_torn(const Mesh& before, const Mesh& after) {
  const FacePairing had = pair_faces(before);
  if (!had.has_nonmanifold_edges) return false;
  const FacePairing has = pair_faces(after);
  if (has.open_sides > had.open_sides) return true;
  for (std::size_t f = 0; f < had.is_closed.size(); ++f)
    if (had.is_closed[f] && !has.is_closed[f]) return true;
  return false;
}

}  // namespace ryosen
