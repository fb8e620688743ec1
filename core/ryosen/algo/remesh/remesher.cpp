#include "ryosen/algo/remesh/remesher.h"

#include <algorithm>
#include <cmath>

#include "ryosen/base/parallel.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/split_edge.h"

namespace ryosen::remesh {

namespace {

constexpr double longest_share = 4.0 / 3, shortest_share = 4.0 / 5, most_share = 2;

}  // namespace

Remesher::Remesher(Edit& edit, const Features& features, const Target& target, SurfaceKeeper& keeper)
    : edit_(edit),
      mesh_(edit.mesh()),
      begun_with_(features),
      features_(features),
      seams_(edit, features_),
      target_(target),
      keeper_(keeper),
      judge_(keeper),
      least_(shortest_share * target.sizing().longest() / 8),
      first_made_(mesh_.vertex_slots()) {
  wanted_.reserve(mesh_.vertex_slots());
  nearby_.reserve(mesh_.vertex_slots());
  for (Vertex v(0); v.index < mesh_.vertex_slots(); ++v.index) {
    wanted_.push_back(target.sizing().length_at(v));
    nearby_.push_back(target.hint_at(v));
  }
}

double Remesher::length_of(Edge e) const {
  const auto [a, b] = ends(mesh_, e);
  return glm::distance(mesh_.position(a), mesh_.position(b));
}

double Remesher::least_at_last() const { return shortest_share * target_.sizing().shortest(); }

bool Remesher::is_pinned(Vertex v) const { return is_fixed(v) && (stays(v) || has_copies(mesh_, v)); }

bool Remesher::is_lasting(double made, Vertex a, Vertex b) const {
  return made < least_at_last() && is_pinned(a) && is_pinned(b) && !stay(a, b);
}

double Remesher::wanted(Edge e) const {
  const auto [a, b] = ends(mesh_, e);
  return std::min(wanted_[a.index], wanted_[b.index]);
}

void Remesher::begin_closing() {
  least_ = least_at_last();
  most_ = most_share * target_.sizing().shortest();
}

std::vector<Edge> Remesher::edges_by_length(bool longest_first, const IsWanted& is_wanted) const {
  using Found = std::vector<std::pair<double, std::uint32_t>>;
  const std::uint32_t n = mesh_.edge_slots();
  constexpr std::size_t steps_for_each = 16;
  const unsigned threads = threads_for(steps_for_each * n), parts = 4 * threads;
  std::vector<Found> by_part(parts);
  for_each_task(parts, threads, [&](unsigned part) {
    for (Edge e(part_begin(n, part, parts)); e.index < part_begin(n, part + 1, parts); ++e.index) {
      if (!mesh_.is_alive(e) || mesh_.is_wire(e)) continue;
      const double length = length_of(e);
      if (std::isfinite(length) && is_wanted(e, length))
        by_part[part].emplace_back(longest_first ? -length : length, e.index);
    }
  });
  Found found = std::move(by_part.front());
  for (std::size_t part = 1; part < by_part.size(); ++part)
    found.insert(found.end(), by_part[part].begin(), by_part[part].end());
  std::sort(found.begin(), found.end());
  std::vector<Edge> edges;
  for (const auto& [length, i] : found) edges.emplace_back(i);
  return edges;
}

bool Remesher::split_long(Progress& progress) {
  const auto is_long = [&](Edge e, double length) { return length > longest_share * wanted(e); };
  constexpr int most_passes = 64;        // of which each halves the longest; more would only follow rounding
  std::vector<std::uint8_t> is_refused;  // by edge: what was asked would be answered the same again
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::vector<Edge> edges = edges_by_length(true, is_long);
    std::size_t done = 0, asked = 0;
    is_refused.resize(mesh_.edge_slots(), 0);
    for (const Edge e : edges) {
      if (asked++ % between_reports == 0 && !progress.go_on()) return false;
      // Another sheet of the same edge may have split it already.
      if (is_refused[e.index] || !is_long(e, length_of(e))) continue;
      if (SplitEdge{halfedge(e)}.check(mesh_).legal() && try_split(e)) {
        ++done;
        continue;
      }
      for (const Halfedge sheet : sheets_between(mesh_, mesh_.from(halfedge(e)), mesh_.to(halfedge(e))))
        is_refused[edge(sheet).index] = 1;
    }
    if (done == 0) break;
  }
  return true;
}

// Whether splitting the edge makes one that is too short; pieces of features do not count.
bool Remesher::makes_short_edges(Edge e, double along) const {
  const Halfedge h = halfedge(e);
  const glm::dvec3 place = SplitEdge{h, along}.position(mesh_);
  if (!is_feature(e) && std::min(along, 1 - along) * length_of(e) < least_) return true;
  const bool is_pinned_there = is_feature(e) && is_cut_on_points(mesh_, h);
  const auto is_near_apex = [&](Halfedge sheet) {
    if (mesh_.is_outside(sheet)) return false;
    const Vertex apex = mesh_.from(mesh_.prev(sheet));
    const double made = glm::distance(place, mesh_.position(apex));
    return made < least_ || (is_pinned_there && made < least_at_last() && is_pinned(apex));
  };
  const auto is_near_apexes = [&](Halfedge sheet) { return is_near_apex(sheet) || is_near_apex(twin(sheet)); };
  if (!has_several_sheets(mesh_, h)) return is_near_apexes(h);
  const std::vector<Halfedge> sheets = sheets_between(mesh_, mesh_.from(h), mesh_.to(h));
  return std::any_of(sheets.begin(), sheets.end(), is_near_apexes);
}

// Where it makes no edge that is too short: as near to the middle as it can be.
std::optional<double> Remesher::split_place(Edge e) const {
  for (const double along : {0.5, 0.35, 0.65, 0.2, 0.8})
    if (!makes_short_edges(e, along)) return along;
  return std::nullopt;
}

bool Remesher::try_split(Edge e) {
  if (!is_feature(e) && makes_short_edges(e, 0.5) && try_swap_cap(e)) return true;
  const std::optional<double> along = split_place(e);
  if (!along) return false;
  const SplitEdge split{halfedge(e), *along};
  if (!keeper_.allows_split(split.halfedge, split.position(mesh_))) return false;
  const Vertex a = point(mesh_, mesh_.from(halfedge(e))), b = point(mesh_, mesh_.to(halfedge(e)));
  const std::uint8_t kind = features_.edges[e.index];
  const double length = (wanted_[a.index] + wanted_[b.index]) / 2, chord = length_of(e);
  const std::uint32_t first = mesh_.vertex_slots(), first_face = mesh_.face_slots();
  split.apply(edit_);
  keeper_.split(Vertex(first), Face(first_face));
  features_.edges.resize(mesh_.edge_slots(), 0);
  features_.vertices.resize(mesh_.vertex_slots(), kind);
  wanted_.resize(mesh_.vertex_slots(), length);
  nearby_.resize(mesh_.vertex_slots(), no_index);
  for (Vertex v(first); v.index < mesh_.vertex_slots(); ++v.index)
    for (const Halfedge h : outgoing(mesh_, v)) {
      const Vertex end = point(mesh_, mesh_.to(h));
      const bool is_half = end == a || end == b;
      features_.edges[edge(h).index] = is_half ? kind : std::uint8_t{Features::none};
      if (is_half) nearby_[v.index] = nearby_[mesh_.to(h).index];  // of its own sheet, not of another one there
    }
  if (kind == Features::seam) seams_.split(e, Vertex(first));
  if (kind != Features::none) return true;
  share_corner_values(Vertex(first));
  // Half way along a chord the surface may lie elsewhere.
  const Vertex middle(first);
  const auto nearest = target_.nearest(mesh_.position(middle), normal_of(middle), nearby_[first]);
  // Not so far that the halves would be nearly as long as the whole.
  if (!nearest || glm::distance(nearest->place, mesh_.position(middle)) > 0.4 * chord) return true;
  wanted_[first] = nearest->length;
  nearby_[first] = nearest->triangle;
  try_move(middle, nearest->place, judge_);
  return true;
}

glm::dvec3 Remesher::normal_of(Vertex v) const {
  glm::dvec3 sum(0);
  for (const Halfedge h : outgoing(mesh_, v))
    if (!mesh_.is_outside(h)) sum += area_normal(corners_of(mesh_, h));
  return sum;
}

bool Remesher::try_move(Vertex v, const glm::dvec3& place, SurfaceKeeper::MoveJudge& judge) {
  if (place == mesh_.position(v)) return true;
  if (!faces_stay(v, place) || !judge.allows(v, place, share_of_reach * wanted_[v.index])) return false;
  edit_.set_position(v, place);
  judge.moved(v);
  return true;
}

// Whether no face around v turns away and no edge becomes too short when v lies at `place`.
bool Remesher::faces_stay(Vertex v, const glm::dvec3& place) const {
  for (const Halfedge h : outgoing(mesh_, v)) {
    const glm::dvec3& end = mesh_.position(mesh_.to(h));
    if (is_too_short(glm::distance(place, end), glm::distance(mesh_.position(v), end))) return false;
    if (mesh_.is_outside(h)) continue;
    Corners corners = corners_of(mesh_, h);
    const glm::dvec3 before = area_normal(corners);
    corners[0] = place;
    if (!keeps_facing(before, area_normal(corners), guard_.turn_cosine)) return false;
    if (!lies_near(corners, v)) return false;
    if (is_narrower(corners, guard_.move_sine) && smallest_sine(corners) < smallest_sine(corners_of(mesh_, h)))
      return false;
  }
  return true;
}

bool Remesher::lies_near(const Corners& corners, Vertex v) const {
  if (!std::isfinite(guard_.beside)) return true;
  const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const auto nearest = target_.nearest(middle, area_normal(corners), nearby_[v.index]);
  return nearest && glm::distance(nearest->place, middle) <= guard_.beside * wanted_[v.index];
}

bool Remesher::collapse_short(Progress& progress) {
  const auto is_short = [&](Edge e, double length) { return length < shortest_share * wanted(e) && may_vanish(e); };
  const std::vector<Edge> edges = edges_by_length(false, is_short);
  std::size_t done = 0;
  for (const Edge e : edges) {
    if (done++ % between_reports == 0 && !progress.go_on()) return false;
    if (mesh_.is_alive(e) && is_short(e, length_of(e))) try_collapse(e);
  }
  return true;
}

bool Remesher::may_vanish(Edge e) const {
  const auto [a, b] = ends(mesh_, e);
  return is_feature(e) ? is_weighed(e) && (is_weighed(a) || is_weighed(b)) : !(is_fixed(a) && is_fixed(b));
}

std::vector<Edge> Remesher::held_by_seams() const {
  std::vector<Edge> held;
  for (const Edge e : live_edges(mesh_)) {
    if (mesh_.is_wire(e) || !(length_of(e) < shortest_share * wanted(e))) continue;
    const auto [a, b] = ends(mesh_, e);
    if (may_vanish(e) || a.index >= first_made_ || b.index >= first_made_) continue;
    const std::uint8_t kind = features_.edges[e.index], at_a = features_.vertices[a.index],
                       at_b = features_.vertices[b.index];
    const bool is_between =
        at_a != Features::none && at_b != Features::none && (at_a != Features::held || at_b != Features::held);
    if (kind == Features::seam || (kind == Features::none && is_between)) held.push_back(e);
  }
  return held;
}

// Along a seam, into the next point of it.
bool Remesher::try_leaving(Halfedge h) {
  return is_weighed(mesh_.from(h)) && try_collapse(h, mesh_.position(mesh_.to(h)));
}

bool Remesher::try_collapse(Edge e) {
  Halfedge h = halfedge(e);
  if (is_feature(e)) return try_leaving(h) || try_leaving(twin(h));
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
  const bool leaves = is_weighed(gone);
  if (leaves && !seams_.allows_collapse(h, share_of_seam_reach * length)) return false;
  if (!keeper_.allows_collapse(h, place, share_of_reach * length)) return false;
  if (leaves) seams_.share_values(h);
  // The edges that vanish may be marked where those that stay are not.
  for (const Halfedge side : {h, twin(h)}) {
    const Edge one = edge(mesh_.prev(side)), other = edge(mesh_.next(side));
    if (!is_feature(one) && !is_feature(other)) continue;
    const bool is_held = features_.edges[one.index] == Features::held || features_.edges[other.index] == Features::held;
    features_.edges[one.index] = features_.edges[other.index] = is_held ? Features::held : Features::seam;
  }
  collapse.apply(edit_);
  if (leaves) seams_.collapsed();
  keeper_.collapsed();
  wanted_[kept.index] = length;
  return true;
}

// No edge around becomes too long, and no face turns.
bool Remesher::may_collapse(Halfedge h, const glm::dvec3& place) const {
  const Halfedge o = twin(h);
  const Vertex kept = mesh_.to(h);
  const double before = std::min(length_of(edge(h)), guard_.mended);
  for (const Halfedge start : {h, o}) {
    const Vertex v = mesh_.from(start);
    if (place == mesh_.position(v)) continue;
    for (const Halfedge out : outgoing(mesh_, v)) {
      const Vertex w = mesh_.to(out);
      if (w != mesh_.from(h) && w != mesh_.to(h)) {
        const double most =
            std::max({longest_share * std::min(wanted_[v.index], wanted_[w.index]), most_, guard_.longest});
        const double made = glm::distance(place, mesh_.position(w));
        const bool is_there = place == mesh_.position(kept) &&
                              (stay(w, kept) || w == mesh_.from(mesh_.prev(h)) || w == mesh_.from(mesh_.prev(o)));
        if (made > most || (!is_there && (is_too_short(made, before) || is_lasting(made, kept, w)))) return false;
      }
      const Face f = mesh_.face(out);
      if (!f || f == mesh_.face(h) || f == mesh_.face(o)) continue;
      Corners corners = corners_of(mesh_, out);
      const glm::dvec3 normal = area_normal(corners);
      corners[0] = place;
      if (!keeps_facing(normal, area_normal(corners), guard_.turn_cosine) || !lies_near(corners, v)) return false;
      if (guard_.sine > 0 && is_narrower(corners, guard_.sine) &&
          smallest_sine(corners) < smallest_sine(corners_of(mesh_, out)))
        return false;
    }
  }
  return true;
}

}  // namespace ryosen::remesh
