#include "core/analysis/neighbourhood.h"

#include <algorithm>

#include "core/analysis/disjoint_sets.h"
#include "core/mesh/circulate.h"

namespace ryosen {

const StarEdge* Star::edge_to(Vertex neighbour_point) const {
  const auto place = std::lower_bound(edges.begin(), edges.end(), neighbour_point,
                                      [](const StarEdge& e, Vertex v) { return e.neighbour < v; });
  return place != edges.end() && place->neighbour == neighbour_point ? &*place : nullptr;
}

std::uint32_t Star::other_boundary_side(std::uint32_t side) const {
  for (;;) {
    const std::uint32_t opposite = side ^ 1u;
    const StarEdge& e = edges[edge_of_side[opposite]];
    if (e.faces.faces() == 1) return opposite;
    if (e.faces.faces() > 2) return no_index;
    side = sides[e.first_side] == opposite ? sides[e.first_side + 1] : sides[e.first_side];
  }
}

namespace {

void gather_corners(const Mesh& mesh, Vertex v, Star& star) {
  for_each_copy(mesh, v, [&](Vertex copy) {
    if (mesh.is_isolated(copy)) return;
    for (Halfedge h : outgoing(mesh, copy))
      if (!mesh.is_outside(h)) star.corners.push_back(h);
  });
  std::sort(star.corners.begin(), star.corners.end());
}

void add_side(const Mesh& mesh, const Star& star, std::uint32_t side, StarEdge& e) {
  const bool arrives = (side & 1u) != 0;
  const Halfedge corner = star.corners[side / 2];
  ++(arrives ? e.faces.backward : e.faces.forward);
  e.first_sheet = std::min(e.first_sheet, edge(arrives ? mesh.prev(corner) : corner));  // none is the largest
  const Face face = mesh.face(corner);
  if (!e.last_face || face > e.last_face) e.last_face = face;
}

void join_fans(Star& star) {
  DisjointSets fans(star.corners.size());
  for (const StarEdge& e : star.edges) {
    for (std::uint32_t i = 1; i < e.faces.faces(); ++i)
      fans.join(star.sides[e.first_side] / 2, star.sides[e.first_side + i] / 2);
    star.has_nonmanifold_edge |= e.faces.is_nonmanifold();
  }
  star.fans = fans.count();
}

}  // namespace

Neighbourhood::Neighbourhood(const Mesh& mesh, Reach reach) : mesh_(mesh) {
  if (reach == Reach::local || !mesh.has_copies()) return;
  points_.assign(mesh.vertex_slots(), Vertex());
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    // Ascending, so the first copy met is the one that names the point.
    if (!mesh.is_alive(Vertex(i)) || points_[i]) continue;
    for_each_copy(mesh, Vertex(i), [&](Vertex copy) { points_[copy.index] = Vertex(i); });
  }
}

Vertex Neighbourhood::point(Vertex v) {
  if (!has_copies(mesh_, v)) return v;
  if (!points_.empty()) return points_[v.index];
  if (const auto known = known_points_.find(v); known != known_points_.end()) return known->second;
  const Vertex p = ryosen::point(mesh_, v);
  for_each_copy(mesh_, v, [&](Vertex copy) { known_points_[copy] = p; });
  return p;
}

bool Neighbourhood::is_plain(Vertex v) const {
  if (has_copies(mesh_, v)) return false;
  if (!mesh_.is_boundary(v)) return true;
  const Halfedge start = mesh_.halfedge(v);
  for (Halfedge h = mesh_.counter_clockwise(start); h != start; h = mesh_.counter_clockwise(h))
    if (mesh_.is_outside(h)) return false;
  return true;
}

const Star& Neighbourhood::star(Vertex v) {
  const Vertex p = point(v);
  if (const auto known = stars_.find(p); known != stars_.end()) return known->second;
  // Elements are asked in an order that stays near, so what was gathered long ago may go.
  constexpr std::size_t most_kept = 2'000'000;
  if (kept_sides_ > most_kept) {
    stars_.clear();
    kept_sides_ = 0;
  }
  Star star;
  gather_corners(mesh_, p, star);
  const auto side_count = static_cast<std::uint32_t>(2 * star.corners.size());
  std::vector<std::pair<Vertex, std::uint32_t>> order(side_count);
  for (std::uint32_t side = 0; side < side_count; ++side) {
    const Halfedge corner = star.corners[side / 2];
    order[side] = {point((side & 1u) != 0 ? mesh_.from(mesh_.prev(corner)) : mesh_.to(corner)), side};
  }
  std::sort(order.begin(), order.end());
  star.sides.resize(side_count);
  star.edge_of_side.resize(side_count);
  for (std::uint32_t i = 0; i < side_count; ++i) {
    const auto [neighbour, side] = order[i];
    if (i == 0 || order[i - 1].first != neighbour) star.edges.push_back({neighbour, {}, {}, {}, i});
    add_side(mesh_, star, side, star.edges.back());
    star.sides[i] = side;
    star.edge_of_side[side] = static_cast<std::uint32_t>(star.edges.size() - 1);
  }
  join_fans(star);
  kept_sides_ += side_count + 16;
  return stars_.emplace(p, std::move(star)).first->second;
}

const StarEdge& Neighbourhood::star_edge(Halfedge h, bool& reversed) {
  static const StarEdge no_faces;
  const Vertex a = point(mesh_.from(h)), b = point(mesh_.to(h));
  // The smaller point's star serves all its edges, which lie side by side.
  reversed = b < a;
  const StarEdge* found = star(std::min(a, b)).edge_to(std::max(a, b));
  return found ? *found : no_faces;
}

PointEdge Neighbourhood::edge(Halfedge h) {
  if (is_single_sheet(h)) return {!mesh_.is_outside(h), !mesh_.is_outside(twin(h))};
  bool reversed = false;
  const PointEdge faces = star_edge(h, reversed).faces;
  return reversed ? PointEdge{faces.backward, faces.forward} : faces;
}

bool Neighbourhood::is_first_sheet(Edge e) {
  const Halfedge h = halfedge(e);
  if (is_single_sheet(h)) return !mesh_.is_outside(h) || !mesh_.is_outside(twin(h));
  bool reversed = false;
  return star_edge(h, reversed).first_sheet == e;
}

Face Neighbourhood::last_face(Halfedge h) {
  if (!is_single_sheet(h)) {
    bool reversed = false;
    return star_edge(h, reversed).last_face;
  }
  const Face f = mesh_.face(h), g = mesh_.face(twin(h));
  return f && g ? std::max(f, g) : std::min(f, g);
}

void Neighbourhood::faces_at(Halfedge h, std::vector<Face>& faces) {
  faces.clear();
  if (is_single_sheet(h)) {
    for (Halfedge side : {h, twin(h)})
      if (!mesh_.is_outside(side)) faces.push_back(mesh_.face(side));
    return;
  }
  const Vertex a = point(mesh_.from(h)), b = point(mesh_.to(h));
  const Star& s = star(std::min(a, b));
  const StarEdge* e = s.edge_to(std::max(a, b));
  if (!e) return;
  for (std::uint32_t i = 0; i < e->faces.faces(); ++i)
    faces.push_back(mesh_.face(s.corners[s.sides[e->first_side + i] / 2]));
}

Halfedge Neighbourhood::across(Halfedge h) {
  if (is_single_sheet(h)) return mesh_.is_outside(twin(h)) ? Halfedge() : twin(h);
  const Star& s = star(mesh_.from(h));
  const auto corner = std::lower_bound(s.corners.begin(), s.corners.end(), h);
  const auto side = static_cast<std::uint32_t>(2 * (corner - s.corners.begin()));
  const StarEdge& e = s.edges[s.edge_of_side[side]];
  if (e.faces.faces() != 2) return Halfedge();
  const std::uint32_t other = s.sides[e.first_side] == side ? s.sides[e.first_side + 1] : s.sides[e.first_side];
  const Halfedge other_corner = s.corners[other / 2];
  return (other & 1u) != 0 ? mesh_.prev(other_corner) : other_corner;
}

std::uint32_t Neighbourhood::fans(Vertex v) {
  if (!is_plain(v)) return star(v).fans;
  // One gap or none: a vertex without a face is isolated or the end of one wire.
  const Halfedge h = mesh_.halfedge(v);
  return h && !(mesh_.is_outside(h) && mesh_.counter_clockwise(h) == h) ? 1 : 0;
}

BoundaryStep Neighbourhood::next_boundary(BoundaryStep step) {
  const Vertex v = step.at_end ? mesh_.to(step.inside) : mesh_.from(step.inside);
  if (is_plain(v)) {
    const Halfedge outside = twin(step.inside);
    return {twin(step.at_end ? mesh_.prev(outside) : mesh_.next(outside)), step.at_end};
  }
  const Vertex other_end = point(step.at_end ? mesh_.from(step.inside) : mesh_.to(step.inside));
  const Star& s = star(v);
  const std::uint32_t side = s.other_boundary_side(s.sides[s.edge_to(other_end)->first_side]);
  if (side == no_index) return {Halfedge(), true};
  const Halfedge corner = s.corners[side / 2];
  return (side & 1u) != 0 ? BoundaryStep{mesh_.prev(corner), false} : BoundaryStep{corner, true};
}

void points_of_face(Neighbourhood& around, Face f, std::vector<Vertex>& points) {
  points.clear();
  for (Vertex v : vertices_around(around.mesh(), f)) points.push_back(around.point(v));
}

}  // namespace ryosen
