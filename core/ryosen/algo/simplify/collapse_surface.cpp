#include "ryosen/algo/simplify/collapse_surface.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "ryosen/algo/features.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/closest.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/prefetch.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/corner_values.h"

namespace ryosen {

namespace {

// A plane along a boundary or crease counts so many times the square of its edge; that of a face, its area.
constexpr double crease_weight = 10;
// Of the square of an edge's length, so that where nothing is lost by any collapse the short edges go first.
constexpr double length_share = 1e-9;

// Of the weight: less than this of squares is that of a place where all planes meet, but for rounding.
constexpr double flat_share = 1e-13;
// The same of the squares of values, most of which are taken off again.
constexpr double value_share = 1e-14;

// What decides the order. The mean square times the root of the weight lies between the sum of squares, by which horns
// and legs of small faces go before a dent in a wide flank, and the mean, by which every small part is kept at the cost
// of all others. Over nine meshes the root mean square distance stays the same at 50 and 10 percent of the faces and is
// a twelfth less at 1.
double cost_of(double squares, double weight, const glm::dvec3& along) {
  return weight > 0 ? (squares + length_share * weight * glm::dot(along, along)) / std::sqrt(weight) : 0;
}

// The square of a gap counts as a mean square of so much of it. Over 21 meshes the largest distance is by 8 percent
// less than without, and by more than with three times or a third of this; the mean one is no larger.
constexpr double share_of_gap = 0.3;

// A face that turns by less than a right angle does so by more than rounding.
constexpr double least_cosine = 1e-9;

bool is_boundary(const Mesh& mesh, Halfedge h) { return mesh.is_outside(h) != mesh.is_outside(twin(h)); }

// A border of a material or group, whose line is to stay.
bool is_border_of_values(const Mesh& mesh, Halfedge h) {
  if (mesh.is_outside(h) || mesh.is_outside(twin(h))) return false;
  return face_values_differ(mesh, mesh.face(h), mesh.face(twin(h)));
}

}  // namespace

CollapseSurface::CollapseSurface(const Mesh& mesh, const CollapseLimits& limits)
    : mesh_(mesh),
      scale_(mesh.positions()),
      boundary_(limits.boundary),
      keeps_boundaries_(boundary_ == BoundaryMode::weighted),
      seams_(limits.seams),
      error_(scale_.scaled_length(limits.error)),
      turn_cosine_(std::max(std::cos(limits.turn_rad), least_cosine)),
      angle_cosine_(limits.smallest_angle_rad > 0 ? std::cos(limits.smallest_angle_rad) : 2),
      states_(mesh.vertex_slots()) {
  const std::uint32_t slots = mesh.vertex_slots();
  for_each_part(slots, threads_for(slots), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const Vertex v(i);
      if (!mesh_.is_alive(v)) continue;
      states_[i].place = scale_.scaled(mesh_.position(v));
      std::uint8_t& flags = states_[i].flags;
      if (!limits.fixed.empty() && limits.fixed[i]) flags |= fixed;
      if (boundary_ == BoundaryMode::locked && mesh_.is_boundary(v)) flags |= on_locked_boundary;
      if (has_copies(mesh_, v) || !is_finite(mesh_.position(v))) flags |= pinned;
    }
  });
  for (const Vertex v : limits.on_lines) states_[v.index].flags |= pinned;
  find_large_faces();
  find_features();
  sum_planes();
  if (auto found = AttributeError::of(*this, limits.colour_weight)) values_.emplace(std::move(*found));
}

void CollapseSurface::find_features() {
  if (corner_attributes(mesh_).empty()) return;
  edge_flags_.resize(mesh_.edge_slots());
  std::vector<std::uint8_t> ends(mesh_.vertex_slots());
  for (const Edge e : live_edges(mesh_)) {
    if (!is_seam(mesh_, halfedge(e))) continue;
    edge_flags_[e.index] |= feature;
    for (unsigned side : {0u, 1u}) {
      std::uint8_t& count = ends[mesh_.from(halfedge(e, side)).index];
      count = static_cast<std::uint8_t>(std::min(count + 1, 3));
    }
  }
  for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
    if (ends[i] == 0) continue;
    states_[i].flags |= on_feature;
    if (ends[i] != 2) states_[i].flags |= seam_end;  // or several meet
    if (ends[i] == 1 && is_tip(Vertex(i))) states_[i].flags |= seam_tip;
  }
}

glm::dvec3 CollapseSurface::summed_area_vector(Face f, Vertex a, Vertex b, const glm::dvec3& place) const {
  const auto at = [&](Halfedge h) {
    const Vertex v = mesh_.from(h);
    return v == a || v == b ? place : states_[v.index].place;
  };
  const Halfedge first = mesh_.halfedge(f);
  const Halfedge second = mesh_.next(first), third = mesh_.prev(first);
  const glm::dvec3 origin = at(first);
  if (mesh_.next(second) == third && !mesh_.has_rings(f)) return glm::cross(at(second) - origin, at(third) - origin);
  glm::dvec3 sum{0.0};
  for_each_loop(mesh_, f, [&](Halfedge start) {
    glm::dvec3 before = at(mesh_.prev(start)) - origin;
    for (Halfedge h : loop(mesh_, start)) {
      const glm::dvec3 here = at(h) - origin;
      sum += glm::cross(before, here);
      before = here;
    }
  });
  return sum;
}

void CollapseSurface::add_edge_plane(Quadric& sum, Halfedge h, double weight) const {
  const Halfedge inside = mesh_.is_outside(h) ? twin(h) : h;
  const glm::dvec3 a = states_[mesh_.from(h).index].place, along = states_[mesh_.to(h).index].place - a;
  const glm::dvec3 across = glm::cross(along, area_vector(mesh_.face(inside)));
  const double length = glm::length(across);
  if (length > 0) sum.add_plane(across / length, a, weight * glm::dot(along, along));
}

void CollapseSurface::sum_planes_at(Vertex v) {
  Quadric& sum = states_[v.index].quadric;
  glm::dvec3 normals{0.0};
  for (Halfedge h : outgoing(mesh_, v)) {
    if (!mesh_.is_outside(h)) {
      const glm::dvec3 normal = area_vector(mesh_.face(h));
      const double length = glm::length(normal);
      if (length > 0) sum.add_plane(normal / length, states_[v.index].place, length);
      normals += normal;
    }
    if (is_feature(edge(h)) || is_border_of_values(mesh_, h) ||
        (boundary_ != BoundaryMode::free && is_boundary(mesh_, h)))
      add_edge_plane(sum, h, crease_weight);
    // A plane across the seam holds its tip from moving along it.
    if ((states_[v.index].flags & seam_tip) && is_feature(edge(h))) {
      const glm::dvec3 along = states_[mesh_.to(h).index].place - states_[v.index].place;
      if (const double length = glm::length(along); length > 0)
        sum.add_plane(along / length, states_[v.index].place, crease_weight * length * length);
    }
  }
  states_[v.index].normal = normals;
}

void CollapseSurface::sum_planes() {
  const std::uint32_t slots = mesh_.vertex_slots();
  for_each_part(slots, threads_for(slots), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i)
      if (const Vertex v(i); mesh_.is_alive(v) && !mesh_.is_isolated(v)) sum_planes_at(v);
  });
}

bool CollapseSurface::is_tip(Vertex v) const {
  if (mesh_.is_boundary(v)) return false;
  std::size_t seams = 0;
  for (const Halfedge h : outgoing(mesh_, v)) seams += is_feature(edge(h));
  return seams == 1;
}

// The rule that keeps a vertex in its place, if any does.
std::optional<EdgeRule> CollapseSurface::hold(Vertex v, bool along_feature) const {
  const std::uint8_t flags = states_[v.index].flags;
  if (flags == 0) return std::nullopt;
  if (flags & pinned) return EdgeRule::structure;
  if (holds_seams() && ((flags & seam_end) || ((flags & on_feature) && !along_feature))) return EdgeRule::seam;
  if (flags & on_locked_boundary) return EdgeRule::boundary;
  return flags & fixed ? std::optional(EdgeRule::selection) : std::nullopt;
}

Freedom CollapseSurface::freedom(Halfedge h) const {
  // Along one whose other side is gone, a vertex would take values to where their chart has none.
  const bool along_feature = is_feature(edge(h)) && !is_boundary(mesh_, h);
  const auto a = hold(mesh_.from(h), along_feature), b = hold(mesh_.to(h), along_feature);
  // A seam that ends in a tip becomes shorter from its other end: at the tip both its sides have one value.
  if (!holds_seams() && is_feature(edge(h))) {
    const bool is_a = states_[mesh_.from(h).index].flags & seam_tip, is_b = states_[mesh_.to(h).index].flags & seam_tip;
    if (is_a || is_b) {
      const auto& goes = is_a ? b : a;
      return {is_a ? twin(h) : h, true, goes ? std::max(*goes, EdgeRule::seam) : EdgeRule::seam,
              !(is_a && is_b) && !goes};
    }
  }
  if (a && b) return {h, true, std::max(*a, *b), false};
  // Points amid the surface go to the boundary, not the other way: the short edges of a small hole would cost little
  // to be drawn out far. That of a hub would move all that is about it, which takes long to ask for each of its edges.
  if (!a && !b && keeps_boundaries_) {
    const bool is_from = mesh_.is_boundary(mesh_.from(h)), is_to = mesh_.is_boundary(mesh_.to(h));
    const Halfedge to_boundary = is_to ? h : twin(h);
    if (is_from != is_to) return {to_boundary, true, EdgeRule::boundary, !is_hub(mesh_, mesh_.from(to_boundary))};
  }
  if (a) return {twin(h), true, *a, true};
  if (b) return {h, true, *b, true};
  return {h};
}

Placing CollapseSurface::at_place(const Freedom& freedom, const glm::dvec3& place, Vertex at) const {
  const Vertex a = mesh_.from(freedom.halfedge), b = mesh_.to(freedom.halfedge);
  const glm::dvec3 &pa = states_[a.index].place, &pb = states_[b.index].place, along = pa - pb;
  // A place that rounding brings to an end is that of the end to the bit.
  if (!at) at = place == pa ? a : place == pb ? b : Vertex();
  const Quadric &qa = states_[a.index].quadric, &qb = states_[b.index].quadric;
  const double squares = qa.at(place) + qb.at(place),
               of_values = values_ ? values_->of_edge(freedom.halfedge).at(place) : 0;
  return {place, squares, cost_of(squares + of_values, qa.weight + qb.weight, along), at};
}

Placing CollapseSurface::lowest(const Freedom& freedom) const {
  const Vertex a = mesh_.from(freedom.halfedge), b = mesh_.to(freedom.halfedge);
  const glm::dvec3 &pa = states_[a.index].place, &pb = states_[b.index].place;
  if (freedom.is_anchored) return at_place(freedom, pb, b);
  const glm::dvec3 middle = 0.5 * (pa + pb), along = pa - pb;
  const Quadric sum = states_[a.index].quadric + states_[b.index].quadric;
  if (values_) return lowest_with_values(freedom, sum);
  const glm::dvec3 place = sum.lowest(middle);
  const double squares = sum.at(place);
  if (squares <= flat_share * sum.weight && place != middle) return lowest_on_flat(freedom, sum, place);
  if (place == pa || place == pb) return at_place(freedom, place);
  return {place, squares, cost_of(squares, sum.weight, along)};
}

Placing CollapseSurface::lowest_with_values(const Freedom& freedom, const Quadric& distances) const {
  const glm::dvec3 &pa = states_[mesh_.from(freedom.halfedge).index].place,
                   &pb = states_[mesh_.to(freedom.halfedge).index].place, middle = 0.5 * (pa + pb);
  const Quadric of_values = values_->of_edge(freedom.halfedge), sum = distances + of_values;
  const glm::dvec3 place = sum.lowest(sum.lowest(middle));  // the second time without what the first one held back
  const double rounding = flat_share * (sum.xx + sum.yy + sum.zz) + value_share * of_values.weight;
  if (sum.at(place) <= rounding && place != middle) return lowest_on_flat(freedom, sum, place);
  if (place == pa || place == pb) return at_place(freedom, place);
  const double squares = distances.at(place);
  return {place, squares, cost_of(squares + of_values.at(place), distances.weight, pa - pb)};
}

// Where all planes meet within rounding: an end that is in all of them, so that flat and straight parts keep their
// corners to the bit. Elsewhere what keeps a place near the edge has moved it by a share of its way, which is taken
// back.
Placing CollapseSurface::lowest_on_flat(const Freedom& freedom, const Quadric& sum, const glm::dvec3& place) const {
  for (const Vertex end : {mesh_.from(freedom.halfedge), mesh_.to(freedom.halfedge)})
    if (sum.is_lowest(states_[end.index].place)) return at_place(freedom, states_[end.index].place, end);
  return at_place(freedom, sum.lowest(sum.lowest(place)));
}

double CollapseSurface::lowest_cost(Halfedge h) const {
  const Freedom found = freedom(h);
  return found.is_possible ? lowest(found).cost : std::numeric_limits<double>::infinity();
}

std::array<Placing, 3> CollapseSurface::others(const Freedom& freedom) const {
  const Vertex a = mesh_.from(freedom.halfedge), b = mesh_.to(freedom.halfedge);
  const glm::dvec3 &pa = states_[a.index].place, &pb = states_[b.index].place;
  std::array<Placing, 3> all{at_place(freedom, pa, a), at_place(freedom, pb, b), at_place(freedom, 0.5 * (pa + pb))};
  std::stable_sort(all.begin(), all.end(), [](const Placing& x, const Placing& y) { return x.cost < y.cost; });
  return all;
}

double CollapseSurface::error_of(Halfedge h, const Placing& placing) const {
  const double weight = states_[mesh_.from(h).index].quadric.weight + states_[mesh_.to(h).index].quadric.weight;
  return weight > 0 ? std::sqrt(placing.squares / weight) : 0;
}

double CollapseSurface::cost_of_gap(Halfedge h, const Placing& placing) const {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const std::array<Vertex, 2> ends{mesh_.from(h), mesh_.to(h)};
  const glm::dvec3& there = placing.place;
  // The squares of the distances of both ends from the new faces, and at a boundary of their place from those of now:
  // amid the surface planes tell that well enough.
  std::array<double, 2> squares{place(ends[0]) == there ? 0 : unknown, place(ends[1]) == there ? 0 : unknown};
  const bool is_at_boundary = mesh_.is_boundary(ends[0]) || mesh_.is_boundary(ends[1]);
  double square_of_place = squares[0] > 0 && squares[1] > 0 && is_at_boundary ? unknown : 0;
  for (const Halfedge end : {h, twin(h)}) {
    if (is_hub(mesh_, mesh_.from(end))) return 0;
    for (const Halfedge corner : outgoing(mesh_, mesh_.from(end))) {
      if (mesh_.is_outside(corner)) continue;
      if (mesh_.next(mesh_.next(corner)) != mesh_.prev(corner)) return 0;
      const Vertex x = mesh_.to(corner), y = mesh_.from(mesh_.prev(corner));
      const auto add = [&](double& least, const glm::dvec3& p, const glm::dvec3& third) {
        if (least > 0) least = std::min(least, squared(way_from_triangle(third, place(x), place(y), p)));
      };
      add(square_of_place, there, place(mesh_.from(end)));
      if (x == ends[0] || x == ends[1] || y == ends[0] || y == ends[1]) continue;  // it goes
      for (const int i : {0, 1}) add(squares[i], place(ends[i]), there);
    }
  }
  const double largest = std::max({squares[0], squares[1], square_of_place});
  if (!(largest < unknown)) return 0;
  const double weight = states_[ends[0].index].quadric.weight + states_[ends[1].index].quadric.weight;
  return cost_of(share_of_gap * largest * weight, weight, glm::dvec3(0.0));
}

bool CollapseSurface::may_swap(Halfedge h) const {
  if (mesh_.is_outside(h) || mesh_.is_outside(twin(h)) || mesh_.face(h) == mesh_.face(twin(h))) return false;
  for (Halfedge side : {h, twin(h)}) {
    if (mesh_.has_rings(mesh_.face(side)) || mesh_.next(mesh_.next(side)) != mesh_.prev(side)) return false;
    if (!is_free(mesh_.from(side)) || !is_free(mesh_.from(mesh_.prev(side)))) return false;
  }
  return !is_feature(edge(h)) && !is_border_of_values(mesh_, h);
}

bool CollapseSurface::is_amid_surface(Vertex v) const {
  if (states_[v.index].flags != 0 || mesh_.is_isolated(v)) return false;
  for (const Halfedge h : outgoing(mesh_, v))
    if (mesh_.is_outside(h) || is_border_of_values(mesh_, h)) return false;
  return true;
}

void CollapseSurface::merge(Vertex gone, Vertex kept, const glm::dvec3& position) {
  State& stays = states_[kept.index];
  const State& goes = states_[gone.index];
  stays.quadric += goes.quadric;
  stays.normal += goes.normal;
  stays.place = scale_.scaled(position);
  ++stays.merges;
  if (values_) values_->merge(gone, kept);
  const bool had_tip = (stays.flags | goes.flags) & seam_tip;
  stays.flags |= static_cast<std::uint8_t>(goes.flags & (on_feature | on_locked_boundary));
  if (had_tip) stays.flags = static_cast<std::uint8_t>(is_tip(kept) ? stays.flags | seam_tip : stays.flags & ~seam_tip);
}

void CollapseSurface::add_copy([[maybe_unused]] Vertex copy, Vertex of) {
  assert(copy.index == states_.size());
  ++states_[of.index].merges;
  states_.push_back(State(states_[of.index]));
  if (values_) values_->add_copy(of);
}

void CollapseSurface::move(Vertex v, const glm::dvec3& position) {
  states_[v.index].place = scale_.scaled(position);
  ++states_[v.index].merges;
}

void CollapseSurface::prefetch_ends(Edge e) const {
  for (unsigned side : {0u, 1u}) {
    const std::uint32_t v = mesh_.from(halfedge(e, side)).index;
    if (v >= states_.size()) return;
    const char* const state = reinterpret_cast<const char*>(states_.data() + v);
    prefetch_line(state);
    prefetch_line(state + 64);
  }
}

}  // namespace ryosen
