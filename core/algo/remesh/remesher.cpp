#include "core/algo/remesh/remesher.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/copies.h"
#include "core/ops/collapse_edge.h"
#include "core/ops/split_edge.h"
#include "core/ops/swap_edge.h"

namespace ryosen::remesh {

namespace {

constexpr double longest_share = 4.0 / 3, shortest_share = 4.0 / 5;
constexpr double cosine_of_turn = 0.5;  // of 60 degrees
constexpr double sliver_sine = 0.34;    // of 20 degrees: no pass but the splits makes a narrower triangle of wider ones
constexpr double share_of_reach = 0.25;  // of the length: how far the surface as it was may be from it as it becomes
constexpr std::size_t between_reports = 256;

// Those on both sides of an edge, and those that a swap makes of them.
struct SwappedTriangles {
  std::array<Corners, 2> before, after;

  bool keep_facing() const {
    for (const Corners& old : before)
      for (const Corners& made : after)
        if (!keeps_facing(area_normal(old), area_normal(made), cosine_of_turn)) return false;
    return true;
  }
  bool has_sliver_before() const { return is_narrower(before[0], sliver_sine) || is_narrower(before[1], sliver_sine); }
  bool has_sliver_after() const { return is_narrower(after[0], sliver_sine) || is_narrower(after[1], sliver_sine); }
  double sine_before() const { return std::min(smallest_sine(before[0]), smallest_sine(before[1])); }
  double sine_after() const { return std::min(smallest_sine(after[0]), smallest_sine(after[1])); }
  bool makes_slivers() const { return has_sliver_after() && sine_after() < sine_before(); }
};
SwappedTriangles triangles_at(const Mesh& mesh, Halfedge h) {
  const glm::dvec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h)),
                   &c = mesh.position(mesh.from(mesh.prev(h))), &d = mesh.position(mesh.from(mesh.prev(twin(h))));
  return {{Corners{a, b, c}, Corners{b, a, d}}, {Corners{c, d, b}, Corners{d, c, a}}};
}

}  // namespace

Remesher::Remesher(Edit& edit, Features features, const Target& target, const WatchedPlaces& watched,
                   CrossingGuard::Surface surface)
    : edit_(edit),
      mesh_(edit.mesh()),
      features_(std::move(features)),
      target_(target),
      keeper_(mesh_, features_, target.shortest_length(), watched, surface) {
  for (Vertex v(0); v.index < mesh_.vertex_slots(); ++v.index) {
    wanted_.push_back(target.length_at(v));
    nearby_.push_back(target.hint_at(v));
  }
}

double Remesher::length_of(Edge e) const {
  const auto [a, b] = ends(mesh_, e);
  return glm::distance(mesh_.position(a), mesh_.position(b));
}

double Remesher::wanted(Edge e) const {
  const auto [a, b] = ends(mesh_, e);
  return std::min(wanted_[a.index], wanted_[b.index]);
}

template <class IsWanted>
std::vector<Edge> Remesher::edges_by_length(bool longest_first, const IsWanted& is_wanted) const {
  std::vector<std::pair<double, std::uint32_t>> found;
  for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
    if (!mesh_.is_alive(Edge(i)) || mesh_.is_wire(Edge(i))) continue;
    const double length = length_of(Edge(i));
    if (std::isfinite(length) && is_wanted(Edge(i), length)) found.emplace_back(longest_first ? -length : length, i);
  }
  std::sort(found.begin(), found.end());
  std::vector<Edge> edges;
  for (const auto& [length, i] : found) edges.emplace_back(i);
  return edges;
}

bool Remesher::split_long(Progress& progress) {
  const auto is_long = [&](Edge e, double length) { return length > longest_share * wanted(e); };
  constexpr int most_passes = 64;  // of which each halves the longest; more would only follow rounding
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::vector<Edge> edges = edges_by_length(true, is_long);
    std::size_t done = 0, asked = 0;
    for (const Edge e : edges) {
      if (asked++ % between_reports == 0 && !progress.go_on()) return false;
      // Another sheet of the same edge may have split it already.
      if (!is_long(e, length_of(e)) || !SplitEdge{halfedge(e)}.check(mesh_).legal()) continue;
      done += try_split(e) ? 1 : 0;
    }
    if (done == 0) break;
  }
  return true;
}

bool Remesher::try_split(Edge e) {
  const SplitEdge split{halfedge(e)};
  if (!keeper_.allows_split(split.halfedge, split.position(mesh_))) return false;
  const Vertex a = point(mesh_, mesh_.from(halfedge(e))), b = point(mesh_, mesh_.to(halfedge(e)));
  const bool was_feature = is_feature(e);
  const double length = (wanted_[a.index] + wanted_[b.index]) / 2, chord = length_of(e);
  const std::uint32_t first = mesh_.vertex_slots(), first_face = mesh_.face_slots();
  split.apply(edit_);
  keeper_.split(Vertex(first), Face(first_face));
  features_.edges.resize(mesh_.edge_slots(), 0);
  features_.vertices.resize(mesh_.vertex_slots(), was_feature ? 1 : 0);
  wanted_.resize(mesh_.vertex_slots(), length);
  nearby_.resize(mesh_.vertex_slots(), nearby_[a.index]);
  for (Vertex v(first); v.index < mesh_.vertex_slots(); ++v.index)
    for (const Halfedge h : outgoing(mesh_, v)) {
      const Vertex end = point(mesh_, mesh_.to(h));
      features_.edges[edge(h).index] = was_feature && (end == a || end == b) ? 1 : 0;
    }
  if (was_feature) return true;
  // Half way along a chord the surface may lie elsewhere.
  const Vertex middle(first);
  const auto nearest = target_.nearest(mesh_.position(middle), normal_of(middle), nearby_[first]);
  // Not so far that the halves would be nearly as long as the whole.
  if (!nearest || glm::distance(nearest->place, mesh_.position(middle)) > 0.4 * chord) return true;
  wanted_[first] = nearest->length;
  nearby_[first] = nearest->triangle;
  try_move(middle, nearest->place);
  return true;
}

glm::dvec3 Remesher::normal_of(Vertex v) const {
  glm::dvec3 sum(0);
  for (const Halfedge h : outgoing(mesh_, v))
    if (!mesh_.is_outside(h)) sum += area_normal(corners_of(mesh_, h));
  return sum;
}

bool Remesher::try_move(Vertex v, const glm::dvec3& place) {
  if (place == mesh_.position(v)) return true;
  if (!faces_stay(v, place) || !keeper_.allows_move(v, place, share_of_reach * wanted_[v.index])) return false;
  edit_.set_position(v, place);
  keeper_.moved(v);
  return true;
}

// Of the faces around v none turns away when it lies at `place`.
bool Remesher::faces_stay(Vertex v, const glm::dvec3& place) const {
  for (const Halfedge h : outgoing(mesh_, v)) {
    if (mesh_.is_outside(h)) continue;
    Corners corners = corners_of(mesh_, h);
    const glm::dvec3 before = area_normal(corners);
    corners[0] = place;
    if (!keeps_facing(before, area_normal(corners), cosine_of_turn)) return false;
    if (is_narrower(corners, sliver_sine) && smallest_sine(corners) < smallest_sine(corners_of(mesh_, h))) return false;
  }
  return true;
}

bool Remesher::collapse_short(Progress& progress) {
  const auto is_short = [&](Edge e, double length) {
    const auto [a, b] = ends(mesh_, e);
    return length < shortest_share * wanted(e) && !is_feature(e) && !(is_fixed(a) && is_fixed(b));
  };
  const std::vector<Edge> edges = edges_by_length(false, is_short);
  std::size_t done = 0;
  for (const Edge e : edges) {
    if (done++ % between_reports == 0 && !progress.go_on()) return false;
    if (mesh_.is_alive(e) && is_short(e, length_of(e))) try_collapse(e);
  }
  return true;
}

bool Remesher::try_collapse(Edge e) {
  Halfedge h = halfedge(e);
  if (is_fixed(mesh_.from(h))) h = twin(h);
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  if (is_fixed(kept)) return try_collapse(h, mesh_.position(kept));
  if (!CollapseEdge{h}.is_legal(mesh_)) return false;
  // Beside the chord the surface lies near: what cannot be done at its middle, cannot be done there.
  const glm::dvec3 middle = 0.5 * mesh_.position(gone) + 0.5 * mesh_.position(kept);
  if (may_collapse(h, middle)) {
    const auto nearest = target_.nearest(middle, normal_of(gone) + normal_of(kept), nearby_[kept.index]);
    if (nearest && glm::distance(nearest->place, middle) < wanted(e) && try_collapse(h, nearest->place)) {
      nearby_[kept.index] = nearest->triangle;
      return true;
    }
  }
  return try_collapse(h, mesh_.position(kept)) || try_collapse(h, mesh_.position(gone));
}

bool Remesher::try_collapse(Halfedge h, const glm::dvec3& place) {
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  const bool stays = is_fixed(kept);
  if (!may_collapse(h, place)) return false;
  const CollapseEdge collapse{h, stays ? CollapseEdge::Place::end : CollapseEdge::Place::point, place};
  if (!collapse.is_legal(mesh_)) return false;
  const double length = stays ? wanted_[kept.index] : std::min(wanted_[gone.index], wanted_[kept.index]);
  if (!keeper_.allows_collapse(h, place, share_of_reach * length)) return false;
  // The edges that vanish may be marked where those that stay are not.
  for (const Halfedge side : {h, twin(h)}) {
    const Edge one = edge(mesh_.prev(side)), other = edge(mesh_.next(side));
    if (is_feature(one) || is_feature(other)) features_.edges[one.index] = features_.edges[other.index] = 1;
  }
  collapse.apply(edit_);
  keeper_.collapsed();
  wanted_[kept.index] = length;
  return true;
}

// No edge around becomes too long, and no face turns.
bool Remesher::may_collapse(Halfedge h, const glm::dvec3& place) const {
  const Halfedge o = twin(h);
  for (const Halfedge start : {h, o}) {
    const Vertex v = mesh_.from(start);
    if (is_fixed(v) && place == mesh_.position(v)) continue;
    for (const Halfedge out : outgoing(mesh_, v)) {
      const Vertex w = mesh_.to(out);
      if (w != mesh_.from(h) && w != mesh_.to(h)) {
        const double most = longest_share * std::min(wanted_[v.index], wanted_[w.index]);
        if (glm::distance(place, mesh_.position(w)) > most) return false;
      }
      const Face f = mesh_.face(out);
      if (!f || f == mesh_.face(h) || f == mesh_.face(o)) continue;
      Corners corners = corners_of(mesh_, out);
      const glm::dvec3 before = area_normal(corners);
      corners[0] = place;
      if (!keeps_facing(before, area_normal(corners), cosine_of_turn)) return false;
    }
  }
  return true;
}

int Remesher::valence_error(Vertex v, int valence) const { return std::abs(valence - (mesh_.is_boundary(v) ? 4 : 6)); }

bool Remesher::swap_for_valence(Progress& progress) {
  std::vector<int> valences(mesh_.vertex_slots(), 0);
  for (std::uint32_t i = 0; i < mesh_.halfedge_slots(); ++i)
    if (mesh_.is_alive(Halfedge(i))) ++valences[mesh_.from(Halfedge(i)).index];
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
  const SwappedTriangles t = triangles_at(mesh_, h);
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
  const SwappedTriangles t = triangles_at(mesh_, halfedge(e));
  constexpr double clearly = 1.1;
  if (!t.has_sliver_before() || t.sine_after() < clearly * t.sine_before() || !t.keep_facing()) return false;
  return swap_if_allowed(halfedge(e));
}

bool Remesher::swap_if_allowed(Halfedge h) {
  const SwapEdge swap{h};
  if (!swap.is_legal(mesh_) || !keeper_.allows_swap(h, share_of_reach * wanted(edge(h)))) return false;
  swap.apply(edit_);
  keeper_.swapped(h);
  return true;
}

std::optional<Remesher::Relaxed> Remesher::relaxed(Vertex v) {
  const glm::dvec3& here = mesh_.position(v);
  glm::dvec3 sum(0), normal(0);
  double weights = 0;
  Vertex first = mesh_.to(mesh_.halfedge(v));
  for (const Halfedge h : outgoing(mesh_, v)) {  // counter-clockwise: the next triangle begins where this one ends
    const Vertex second = mesh_.from(mesh_.prev(h));
    const Corners c{here, mesh_.position(first), mesh_.position(second)};
    const glm::dvec3 area = area_normal(c);
    double weight = glm::length(area);
    if (target_.is_adaptive()) weight /= std::pow(wanted_[first.index] + wanted_[second.index], 2);
    sum += weight * (c[0] + c[1] + c[2]) / 3.0;
    normal += area;
    weights += weight;
    first = second;
  }
  if (!(weights > 0)) return std::nullopt;
  normal = unit_or_zero(normal);
  const glm::dvec3 mean = sum / weights;
  const auto nearest = target_.nearest(mean + glm::dot(normal, here - mean) * normal, normal, nearby_[v.index]);
  if (!nearest || glm::distance(nearest->place, here) > wanted_[v.index]) return std::nullopt;
  nearby_[v.index] = nearest->triangle;
  return Relaxed{nearest->place, nearest->length};
}

bool Remesher::relax(Progress& progress) {
  const std::uint32_t n = mesh_.vertex_slots();
  std::vector<std::optional<Relaxed>> found(n);
  constexpr std::uint32_t block = 1 << 15;
  for (std::uint32_t first = 0; first < n; first += block) {
    if (!progress.go_on()) return false;
    const std::uint32_t count = std::min(block, n - first);
    for_each_part(count, count > 2000 ? threads_for(1000000) : 1,
                  [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                    for (Vertex v(first + begin); v.index < first + end; ++v.index)
                      if (mesh_.is_alive(v) && !is_fixed(v)) found[v.index] = relaxed(v);
                  });
  }
  for (Vertex v(0); v.index < n; ++v.index) {
    if (v.index % block == 0 && !progress.go_on()) return false;
    if (found[v.index] && try_move(v, found[v.index]->place)) wanted_[v.index] = found[v.index]->length;
  }
  return progress.go_on();
}

}  // namespace ryosen::remesh
