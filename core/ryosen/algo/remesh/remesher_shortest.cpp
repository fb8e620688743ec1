// The last pass: what is left shorter than any edge that is wanted.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ryosen/algo/remesh/remesher.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::remesh {

namespace {

constexpr double clearly = 1 + 1e-6;

}  // namespace

// Begins with what changes least; slivers, longer edges and larger turns are made only where nothing else helps, and
// points of the surface as it was are left only at last.
bool Remesher::remove_shortest(Progress& progress) {
  constexpr double any_turn = -2, least = needle_sine, any = std::numeric_limits<double>::infinity();
  for (const Guard& guard :
       {Guard{cosine_of_turn, 0, sliver_sine}, Guard{cosine_of_turn, 0, 0.5 * sliver_sine},
        Guard{cosine_of_turn, 2 * most_, least}, Guard{0.1, 2 * most_, least},
        Guard{0.1, 2 * most_, least, least, 1.5, 0.5}, Guard{0.1, any, least, least, 1.5, 0.5},
        Guard{any_turn, any, least, least, 1.5, 0.5}, Guard{any_turn, any, least, least, any, 0.5},
        Guard{any_turn, 2 * most_, least, least, any, 1}, Guard{any_turn, 2 * most_, least, least, any},
        Guard{any_turn, any, 0, 0, any}, Guard{any_turn, any, 0, 0, 1.5, 1, true}, Guard{any_turn, any, 0, 0, any}}) {
    std::size_t left = 0;
    guard_ = guard;
    keeper_.widen(guard.reach);
    const bool goes_on = mend_all(progress, left);
    guard_ = {};
    keeper_.widen(1);
    if (!goes_on || left == 0) return goes_on;
  }
  return true;
}

// Where `left` is 0 no short one is.
bool Remesher::mend_all(Progress& progress, std::size_t& left) {
  constexpr int most_turns = 8;
  const auto is_short_one = [&](Edge e, double length) { return is_short(e, length); };
  std::size_t mended = 1, asked = 0;
  for (int turn = 0; turn < most_turns && mended > 0; ++turn) {
    const std::vector<Edge> edges = edges_by_length(false, is_short_one);
    mended = 0;
    for (const Edge e : edges) {
      if (asked++ % between_reports == 0 && !progress.go_on()) return false;
      if (mesh_.is_alive(e) && is_short(e, length_of(e)) && mend_short(e)) ++mended;
    }
    left = edges.size();
  }
  return true;
}

bool Remesher::is_short(Edge e, double length) const {
  const auto [a, b] = ends(mesh_, e);
  return length < least_ && !is_feature(e) && !stay(a, b);
}

std::size_t Remesher::short_edges() const {
  std::size_t found = 0;
  for (const Edge e : live_edges(mesh_))
    if (!mesh_.is_wire(e) && is_short(e, length_of(e))) ++found;
  return found;
}

bool Remesher::mend_short(Edge e) {
  if (guard_.reach > 1) guard_.mended = length_of(e);
  return mend_at_once(e) || (guard_.in_two_steps && mend_in_two_steps(e));
}

// Swaps an edge beside the short one, or removes a vertex around it, where that opens a way. Steps that open none stay.
bool Remesher::mend_in_two_steps(Edge e) {
  const auto is_mended = [&] { return !mesh_.is_alive(e) || !is_short(e, length_of(e)) || mend_at_once(e); };
  const std::array<Halfedge, 2> sides{halfedge(e), twin(halfedge(e))};
  for (const Halfedge side : sides) {
    if (!mesh_.face(side)) continue;
    for (const Halfedge beside : {mesh_.next(side), mesh_.prev(side)})
      if (swap_longer(beside) && is_mended()) return true;
  }
  std::vector<Vertex> around;
  for (const Halfedge side : sides)
    for (const Halfedge h : outgoing(mesh_, mesh_.from(side)))
      if (edge(h) != e) around.push_back(mesh_.to(h));
  for (const Vertex v : around)
    if (mesh_.is_alive(v) && remove_vertex(v) && is_mended()) return true;
  return false;
}

bool Remesher::mend_at_once(Edge e) {
  const Halfedge h = halfedge(e);
  const std::array<Halfedge, 2> sides{h, twin(h)};
  if (!(is_fixed(mesh_.from(h)) && is_fixed(mesh_.to(h))) && try_collapse(e)) return true;
  if (swap_longer(h)) return true;
  for (const Halfedge side : sides)
    if (move_apart(side)) return true;
  for (const Halfedge side : sides)
    if (remove_vertex(mesh_.from(side))) return true;
  return false;
}

// Where the other diagonal is long enough, or one between points that stay.
bool Remesher::swap_longer(Halfedge h) {
  const Vertex c = mesh_.from(mesh_.prev(h)), d = mesh_.from(mesh_.prev(twin(h)));
  if (is_feature(edge(h))) return false;
  const bool is_fine = stay(c, d) || glm::distance(mesh_.position(c), mesh_.position(d)) >= least_;
  return is_fine && is_guarded_swap(h) && swap_if_kept(h);
}

// The first end farther from the other, along the surface.
bool Remesher::move_apart(Halfedge h) {
  const Vertex v = mesh_.from(h);
  if (is_fixed(v)) return false;
  const glm::dvec3 here = mesh_.position(v), other = mesh_.position(mesh_.to(h)), normal = unit_or_zero(normal_of(v));
  const glm::dvec3 away = here - other, along = unit_or_zero(away - glm::dot(away, normal) * normal),
                   across = glm::cross(normal, along);
  for (const double turn_rad : {0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2})
    for (const double length : {1.0, 1.1}) {
      const glm::dvec3 way = std::cos(turn_rad) * along + std::sin(turn_rad) * across;
      const auto nearest = target_.nearest(other + length * least_ * clearly * way, normal, nearby_[v.index]);
      if (!nearest || !(glm::distance(nearest->place, other) >= least_) || !try_move(v, nearest->place, judge_))
        continue;
      wanted_[v.index] = nearest->length;
      nearby_[v.index] = nearest->triangle;
      return true;
    }
  return false;
}

// Into one of the vertices around it; one that was put on a feature along that.
bool Remesher::remove_vertex(Vertex v) {
  if (stays(v) || (is_fixed(v) && has_copies(mesh_, v))) return false;
  std::vector<std::pair<double, Halfedge>> ways;
  for (const Halfedge h : outgoing(mesh_, v))
    if (!is_fixed(v) || is_feature(edge(h))) ways.emplace_back(length_of(edge(h)), h);
  std::sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return std::any_of(ways.begin(), ways.end(),
                     [&](const auto& way) { return try_collapse(way.second, mesh_.position(mesh_.to(way.second))); });
}

}  // namespace ryosen::remesh
