#include "core/algo/simplify/collapse_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/prefetch.h"
#include "core/mesh/rings.h"
#include "core/ops/rules/corner_values.h"

namespace ryosen {

namespace {

// A plane along a boundary or crease counts so many times the square of its edge; that of a face, its area.
constexpr double crease_weight = 10;
// Of the square of an edge's length, so that where nothing is lost by any collapse the short edges go first.
constexpr double length_share = 1e-9;
// A face that turns by less than a right angle does so by more than rounding.
constexpr double least_cosine = 1e-9;

bool have_other_face_values(const Mesh& mesh, Face f, Face g) {
  for (const AttributeColumn& column : mesh.attributes()) {
    if (column.element != ElementKind::face) continue;
    const std::uint32_t* const data = column.data.data();
    if (!std::equal(data + std::size_t{f.index} * column.words, data + (std::size_t{f.index} + 1) * column.words,
                    data + std::size_t{g.index} * column.words))
      return true;
  }
  return false;
}

// An edge whose line is to stay: a boundary, a border of a material or group.
bool is_crease(const Mesh& mesh, Halfedge h) {
  if (mesh.is_wire(edge(h))) return false;
  if (mesh.is_outside(h) || mesh.is_outside(twin(h))) return true;
  return have_other_face_values(mesh, mesh.face(h), mesh.face(twin(h)));
}

}  // namespace

CollapseSurface::CollapseSurface(const Mesh& mesh, const CollapseLimits& limits)
    : mesh_(mesh),
      scale_(mesh.positions()),
      boundary_(limits.boundary),
      error_(scale_.scaled_length(limits.error)),
      turn_cosine_(std::max(std::cos(limits.turn_rad), least_cosine)),
      angle_cosine_(limits.smallest_angle_rad > 0 ? std::cos(limits.smallest_angle_rad) : 2),
      places_(mesh.vertex_slots()),
      quadrics_(mesh.vertex_slots()),
      vertex_flags_(mesh.vertex_slots()),
      edge_flags_(mesh.edge_slots()) {
  const std::uint32_t slots = mesh.vertex_slots();
  for_each_part(slots, threads_for(slots), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const Vertex v(i);
      if (!mesh_.is_alive(v)) continue;
      places_[i] = scale_.scaled(mesh_.position(v));
      std::uint8_t& flags = vertex_flags_[i];
      if (!limits.fixed.empty() && limits.fixed[i]) flags |= fixed;
      if (boundary_ == BoundaryMode::locked && mesh_.is_boundary(v)) flags |= on_locked_boundary;
      if (has_copies(mesh_, v) || !is_finite(mesh_.position(v))) flags |= pinned;
    }
  });
  find_features();
  sum_planes();
}

void CollapseSurface::find_features() {
  if (corner_attributes(mesh_).empty()) return;
  std::vector<std::uint8_t> ends(mesh_.vertex_slots());
  for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
    const Edge e(i);
    if (!mesh_.is_alive(e) || !is_seam(mesh_, halfedge(e))) continue;
    edge_flags_[i] |= feature;
    for (unsigned side : {0u, 1u}) {
      std::uint8_t& count = ends[mesh_.from(halfedge(e, side)).index];
      count = static_cast<std::uint8_t>(std::min(count + 1, 3));
    }
  }
  for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
    if (ends[i] == 0) continue;
    vertex_flags_[i] |= on_feature;
    if (ends[i] != 2) vertex_flags_[i] |= pinned;  // a seam ends here, or several meet
  }
}

glm::dvec3 CollapseSurface::area_vector(Face f, Vertex a, Vertex b, const glm::dvec3& place) const {
  const auto at = [&](Halfedge h) {
    const Vertex v = mesh_.from(h);
    return v == a || v == b ? place : places_[v.index];
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
  const glm::dvec3 a = places_[mesh_.from(h).index], along = places_[mesh_.to(h).index] - a;
  const glm::dvec3 across = glm::cross(along, area_vector(mesh_.face(inside)));
  const double length = glm::length(across);
  if (length > 0) sum.add_plane(across / length, a, weight * glm::dot(along, along));
}

void CollapseSurface::sum_planes_at(Vertex v) {
  Quadric& sum = quadrics_[v.index];
  for (Halfedge h : outgoing(mesh_, v)) {
    if (!mesh_.is_outside(h)) {
      const glm::dvec3 normal = area_vector(mesh_.face(h));
      const double length = glm::length(normal);
      if (length > 0) sum.add_plane(normal / length, places_[v.index], length);
    }
    const bool is_seam = edge_flags_[edge(h).index] & feature;
    if (is_seam || (boundary_ != BoundaryMode::free && is_crease(mesh_, h))) add_edge_plane(sum, h, crease_weight);
  }
}

void CollapseSurface::sum_planes() {
  const std::uint32_t slots = mesh_.vertex_slots();
  for_each_part(slots, threads_for(slots), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i)
      if (const Vertex v(i); mesh_.is_alive(v) && !mesh_.is_isolated(v)) sum_planes_at(v);
  });
}

// The rule that keeps a vertex in its place, if any does.
std::optional<EdgeRule> CollapseSurface::hold(Vertex v, bool along_feature) const {
  const std::uint8_t flags = vertex_flags_[v.index];
  if (!(flags & (fixed | on_locked_boundary | on_feature | pinned))) return std::nullopt;
  if ((flags & pinned) || ((flags & on_feature) && !along_feature)) return EdgeRule::structure;
  if (flags & on_locked_boundary) return EdgeRule::boundary;
  return flags & fixed ? std::optional(EdgeRule::selection) : std::nullopt;
}

Freedom CollapseSurface::freedom(Halfedge h) const {
  const bool along_feature = is_feature(edge(h));
  const auto a = hold(mesh_.from(h), along_feature), b = hold(mesh_.to(h), along_feature);
  if (a && b) return {h, true, std::max(*a, *b), false};
  if (a) return {twin(h), true, *a, true};
  if (b) return {h, true, *b, true};
  return {h};
}

Placing CollapseSurface::at_place(const Freedom& freedom, const glm::dvec3& place, Vertex at) const {
  const Vertex a = mesh_.from(freedom.halfedge), b = mesh_.to(freedom.halfedge);
  const glm::dvec3 along = places_[a.index] - places_[b.index];
  const Quadric &qa = quadrics_[a.index], &qb = quadrics_[b.index];
  const double squares = qa.at(place) + qb.at(place);
  return {place, squares, squares + length_share * (qa.weight + qb.weight) * glm::dot(along, along), at};
}

Placing CollapseSurface::lowest(const Freedom& freedom) const {
  const Vertex a = mesh_.from(freedom.halfedge), b = mesh_.to(freedom.halfedge);
  const glm::dvec3 &pa = places_[a.index], &pb = places_[b.index];
  if (freedom.is_anchored) return at_place(freedom, pb, b);
  const glm::dvec3 middle = 0.5 * (pa + pb), along = pa - pb;
  const Quadric sum = quadrics_[a.index] + quadrics_[b.index];
  const glm::dvec3 place = sum.lowest(middle);
  const double squares = sum.at(place);
  return {place, squares, squares + length_share * sum.weight * glm::dot(along, along)};
}

double CollapseSurface::lowest_cost(Halfedge h) const {
  const Freedom found = freedom(h);
  return found.is_possible ? lowest(found).cost : std::numeric_limits<double>::infinity();
}

std::array<Placing, 3> CollapseSurface::others(const Freedom& freedom) const {
  const Vertex a = mesh_.from(freedom.halfedge), b = mesh_.to(freedom.halfedge);
  const glm::dvec3 &pa = places_[a.index], &pb = places_[b.index];
  std::array<Placing, 3> all{at_place(freedom, pa, a), at_place(freedom, pb, b), at_place(freedom, 0.5 * (pa + pb))};
  std::stable_sort(all.begin(), all.end(), [](const Placing& x, const Placing& y) { return x.cost < y.cost; });
  return all;
}

double CollapseSurface::error_of(Halfedge h, const Placing& placing) const {
  const double weight = quadrics_[mesh_.from(h).index].weight + quadrics_[mesh_.to(h).index].weight;
  return weight > 0 ? std::sqrt(placing.squares / weight) : 0;
}

// A face without area may turn as it likes; one with area may not lose it.
bool CollapseSurface::turns_too_far(const glm::dvec3& before, const glm::dvec3& after) const {
  const double square = glm::dot(before, before);
  if (!(square > 0)) return false;
  const double product = glm::dot(before, after);
  return !(product > 0) || product * product < turn_cosine_ * turn_cosine_ * square * glm::dot(after, after);
}

template <class Look>
bool CollapseSurface::any_changed_corner(Halfedge h, const glm::dvec3& place, Look look) const {
  const auto vanishes = [&](Face f) {
    return (f == mesh_.face(h) || f == mesh_.face(twin(h))) && !mesh_.has_rings(f) &&
           mesh_.next(mesh_.next(mesh_.halfedge(f))) == mesh_.prev(mesh_.halfedge(f));
  };
  for (Halfedge end : {h, twin(h)}) {
    if (places_[mesh_.from(end).index] == place) continue;
    Halfedge corner = end;
    do {
      if (const Face f = mesh_.face(corner); f && !vanishes(f) && look(corner)) return true;
      corner = mesh_.counter_clockwise(corner);
    } while (corner != end);
  }
  return false;
}

bool CollapseSurface::turns_face(Halfedge h, const glm::dvec3& place) const {
  const Vertex a = mesh_.from(h), b = mesh_.to(h);
  return any_changed_corner(h, place, [&](Halfedge corner) {
    const Face f = mesh_.face(corner);
    const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
    if (mesh_.next(next) != prev || mesh_.has_rings(f))
      return turns_too_far(area_vector(f), area_vector(f, a, b, place));
    const glm::dvec3 &p = places_[mesh_.from(corner).index], &x = places_[mesh_.from(next).index],
                     &y = places_[mesh_.from(prev).index];
    const glm::dvec3 side = y - x;
    return turns_too_far(glm::cross(side, p - x), glm::cross(side, place - x));
  });
}

namespace {

// The largest cosine at the corners of a triangle; 1 where two of them meet.
double largest_cosine(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto at = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    const double product = glm::dot(q - p, q - p) * glm::dot(r - p, r - p);
    return product > 0 ? glm::dot(q - p, r - p) / std::sqrt(product) : 1;
  };
  return std::max({at(a, b, c), at(b, c, a), at(c, a, b)});
}

}  // namespace

bool CollapseSurface::narrows_face(Halfedge h, const glm::dvec3& place) const {
  if (angle_cosine_ > 1) return false;
  return any_changed_corner(h, place, [&](Halfedge corner) {
    const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
    if (mesh_.next(next) != prev) return false;  // angles are those of triangles
    const glm::dvec3 &p = places_[mesh_.from(corner).index], &x = places_[mesh_.from(next).index],
                     &y = places_[mesh_.from(prev).index];
    const double after = largest_cosine(place, x, y);
    return after > angle_cosine_ && after > largest_cosine(p, x, y);
  });
}

void CollapseSurface::merge(Vertex gone, Vertex kept, const glm::dvec3& place) {
  quadrics_[kept.index] += quadrics_[gone.index];
  places_[kept.index] = place;
  vertex_flags_[kept.index] |= static_cast<std::uint8_t>(vertex_flags_[gone.index] & (on_feature | on_locked_boundary));
}

void CollapseSurface::prefetch_ends(Edge e) const {
  for (unsigned side : {0u, 1u}) {
    const std::uint32_t v = mesh_.from(halfedge(e, side)).index;
    if (v >= quadrics_.size()) return;
    prefetch_cell(places_.data(), v);
    const char* const quadric = reinterpret_cast<const char*>(quadrics_.data() + v);
    __builtin_prefetch(quadric);
    __builtin_prefetch(quadric + 64);
  }
}

}  // namespace ryosen
