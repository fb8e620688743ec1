// Swaps of edges, for even valences and against slivers.
#include <algorithm>
#include <cmath>

#include "ryosen/algo/remesh/remesher.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/swap_edge.h"

namespace ryosen::remesh {

// The triangles on both sides of an edge, and those that a swap makes of them.
struct Remesher::SwappedTriangles {
  std::array<Corners, 2> before, after;

  bool keep_facing(double least_cosine = cosine_of_turn) const {
    for (const Corners& old : before)
      for (const Corners& made : after)
        if (!keeps_facing(area_normal(old), area_normal(made), least_cosine)) return false;
    return true;
  }
  bool has_sliver_before() const { return is_narrower(before[0], sliver_sine) || is_narrower(before[1], sliver_sine); }
  bool has_sliver_after() const { return is_narrower(after[0], sliver_sine) || is_narrower(after[1], sliver_sine); }
  double sine_before() const { return std::min(smallest_sine(before[0]), smallest_sine(before[1])); }
  double sine_after() const { return std::min(smallest_sine(after[0]), smallest_sine(after[1])); }
  bool makes_slivers() const { return has_sliver_after() && sine_after() < sine_before(); }
};
Remesher::SwappedTriangles Remesher::triangles_at(Halfedge h) const {
  const glm::dvec3 &a = mesh_.position(mesh_.from(h)), &b = mesh_.position(mesh_.to(h)),
                   &c = mesh_.position(mesh_.from(mesh_.prev(h))), &d = mesh_.position(mesh_.from(mesh_.prev(twin(h))));
  return {{Corners{a, b, c}, Corners{b, a, d}}, {Corners{c, d, b}, Corners{d, c, a}}};
}

int Remesher::valence_error(Vertex v, int valence) const { return std::abs(valence - (mesh_.is_boundary(v) ? 4 : 6)); }

bool Remesher::swap_for_valence(Progress& progress) {
  std::vector<int> valences(mesh_.vertex_slots(), 0);
  for (const Halfedge h : live_halfedges(mesh_)) ++valences[mesh_.from(h).index];
  for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
    if (i % (between_reports * 16) == 0 && !progress.go_on()) return false;
    if (mesh_.is_alive(Edge(i)) && !is_feature(Edge(i))) try_swap(Edge(i), valences);
  }
  return true;
}

bool Remesher::try_swap(Edge e, std::vector<int>& valences) {
  const Halfedge h = halfedge(e), o = twin(h);
  const Vertex a = mesh_.from(h), b = mesh_.to(h), c = mesh_.from(mesh_.prev(h)), d = mesh_.from(mesh_.prev(o));
  const auto error = [&](Vertex v, int more) { return valence_error(v, valences[v.index] + more); };
  const int now = error(a, 0) + error(b, 0) + error(c, 0) + error(d, 0);
  if (error(a, -1) + error(b, -1) + error(c, 1) + error(d, 1) >= now) return false;
  const SwappedTriangles t = triangles_at(h);
  if (!t.keep_facing() || t.makes_slivers()) return false;
  if (!swap_if_allowed(h)) return false;
  --valences[a.index];
  --valences[b.index];
  ++valences[c.index];
  ++valences[d.index];
  return true;
}

bool Remesher::swap_slivers(Progress& progress) {
  constexpr int most_turns = 8;
  std::size_t swapped = 1;
  for (int turn = 0; turn < most_turns && swapped > 0; ++turn) {
    swapped = 0;
    for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
      if (i % (between_reports * 16) == 0 && !progress.go_on()) return false;
      if (mesh_.is_alive(Edge(i)) && !is_feature(Edge(i))) swapped += try_swap_sliver(Edge(i)) ? 1 : 0;
    }
  }
  return true;
}

bool Remesher::try_swap_sliver(Edge e) {
  const SwappedTriangles t = triangles_at(halfedge(e));
  constexpr double clearly = 1.1;
  if (!t.has_sliver_before() || t.sine_after() < clearly * t.sine_before() || !t.keep_facing()) return false;
  return swap_if_allowed(halfedge(e));
}

// A long edge over whose middle a corner lies near: what splitting it and joining the two would come to.
bool Remesher::try_swap_cap(Edge e) {
  const SwappedTriangles t = triangles_at(halfedge(e));
  return t.sine_after() > t.sine_before() && t.keep_facing() && swap_if_allowed(halfedge(e));
}

// Whether no face turns too far, nor becomes narrower than the guard lets it.
bool Remesher::is_guarded_swap(Halfedge h) const {
  const SwappedTriangles t = triangles_at(h);
  const bool is_near = lies_near(t.after[0], mesh_.from(h)) && lies_near(t.after[1], mesh_.from(h));
  return is_near && t.keep_facing(guard_.turn_cosine) &&
         (t.sine_after() >= guard_.sine || t.sine_after() >= t.sine_before());
}

bool Remesher::swap_if_allowed(Halfedge h) {
  const Vertex c = mesh_.from(mesh_.prev(h)), d = mesh_.from(mesh_.prev(twin(h)));
  const double made = glm::distance(mesh_.position(c), mesh_.position(d));
  // How far apart two points are that stay is given: their edge is no reason for another short one.
  const bool is_given = made < least_ && stay(mesh_.from(h), mesh_.to(h));
  return !is_given && !is_too_short(made, length_of(edge(h))) && !is_lasting(made, c, d) && swap_if_kept(h);
}

bool Remesher::swap_if_kept(Halfedge h) {
  const SwapEdge swap{h};
  if (!swap.is_legal(mesh_) || !keeper_.allows_swap(h, share_of_reach * wanted(edge(h)))) return false;
  swap.apply(edit_);
  keeper_.swapped(h);
  return true;
}

}  // namespace ryosen::remesh
