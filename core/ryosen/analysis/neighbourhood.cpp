#include "ryosen/analysis/neighbourhood.h"

#include <algorithm>
#include <array>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/live_elements.h"

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

bool Neighbourhood::is_plain(Vertex v) const {
  if (has_copies(mesh_, v)) return false;
  if (!mesh_.is_boundary(v)) return true;
  const Halfedge start = mesh_.halfedge(v);
  for (Halfedge h = mesh_.counter_clockwise(start); h != start; h = mesh_.counter_clockwise(h))
    if (mesh_.is_outside(h)) return false;
  return true;
}

void Neighbourhood::gather_corners(Vertex p, StarRecord& record) {
  record.first_corner = static_cast<std::uint32_t>(corners_.size());
  for_each_copy(mesh_, p, [&](Vertex copy) {
    if (mesh_.is_isolated(copy)) return;
    for (Halfedge h : outgoing(mesh_, copy))
      if (!mesh_.is_outside(h)) corners_.push_back(h);
  });
  record.corners = static_cast<std::uint32_t>(corners_.size()) - record.first_corner;
  std::sort(corners_.begin() + record.first_corner, corners_.end());
}

void Neighbourhood::gather_edges(StarRecord& record) {
  const Halfedge* corners = corners_.data() + record.first_corner;
  order_.clear();
  for (std::uint32_t side = 0; side < 2 * record.corners; ++side) {
    const Halfedge corner = corners[side / 2];
    order_.emplace_back(point((side & 1u) != 0 ? mesh_.from(mesh_.prev(corner)) : mesh_.to(corner)), side);
  }
  std::sort(order_.begin(), order_.end());
  record.first_edge = static_cast<std::uint32_t>(edges_.size());
  edge_of_side_.resize(2 * corners_.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) {
    const auto [neighbour, side] = order_[i];
    if (i == 0 || order_[i - 1].first != neighbour) edges_.push_back({neighbour, {}, {}, {}, i});
    StarEdge& e = edges_.back();
    const bool arrives = (side & 1u) != 0;
    const Halfedge corner = corners[side / 2];
    ++(arrives ? e.faces.backward : e.faces.forward);
    // None compares largest.
    e.first_sheet = std::min(e.first_sheet, ryosen::edge(arrives ? mesh_.prev(corner) : corner));
    const Face face = mesh_.face(corner);
    if (!e.last_face || face > e.last_face) e.last_face = face;
    sides_.push_back(side);
    edge_of_side_[2 * std::size_t{record.first_corner} + side] =
        static_cast<std::uint32_t>(edges_.size() - 1 - record.first_edge);
  }
  record.edges = static_cast<std::uint32_t>(edges_.size()) - record.first_edge;
}

void Neighbourhood::join_fans(StarRecord& record) {
  fans_.reset(record.corners);
  const Star star = view(record);
  for (const StarEdge& e : star.edges) {
    for (std::uint32_t i = 1; i < e.faces.faces(); ++i)
      fans_.join(star.sides[e.first_side] / 2, star.sides[e.first_side + i] / 2);
    record.has_nonmanifold_edge |= e.faces.is_nonmanifold();
  }
  record.fans = fans_.count();
}

Star Neighbourhood::view(const StarRecord& r) const {
  const std::size_t first_side = 2 * std::size_t{r.first_corner}, sides = 2 * std::size_t{r.corners};
  return {{corners_.data() + r.first_corner, r.corners},
          {edges_.data() + r.first_edge, r.edges},
          {sides_.data() + first_side, sides},
          {edge_of_side_.data() + first_side, sides},
          r.fans,
          r.has_nonmanifold_edge};
}

std::uint32_t& Neighbourhood::record_of(Vertex p) {
  if (!is_whole_) return known_records_.try_emplace(p, no_index).first->second;
  if (record_of_point_.empty()) record_of_point_.assign(mesh_.vertex_slots(), no_index);
  return record_of_point_[p.index];
}

Star Neighbourhood::star(Vertex v) {
  const Vertex p = point(v);
  std::uint32_t& number = record_of(p);
  if (number == no_index) {
    StarRecord record;
    gather_corners(p, record);
    gather_edges(record);
    join_fans(record);
    records_.push_back(record);
    number = static_cast<std::uint32_t>(records_.size() - 1);
  }
  return view(records_[number]);
}

StarEdge Neighbourhood::star_edge(Halfedge h, bool& reversed) {
  const Vertex a = point(mesh_.from(h)), b = point(mesh_.to(h));
  // Use the smaller point's star: edges sorted by smaller point then share it.
  reversed = b < a;
  const StarEdge* found = star(std::min(a, b)).edge_to(std::max(a, b));
  return found ? *found : StarEdge();
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

// The lowest edge without faces between the same points, one of which has copies.
Edge Neighbourhood::first_wire(Edge e) {
  const auto keep = [&](Edge wire) {
    const auto [a, b] = ends(mesh_, wire);
    const std::uint64_t low = std::min(point(a), point(b)).index, high = std::max(point(a), point(b)).index;
    Edge& first = first_wires_.try_emplace(low << 32 | high, wire).first->second;
    return first = std::min(first, wire);
  };
  const auto [a, b] = ends(mesh_, e);
  if (!is_whole_)
    for (const Halfedge h : sheets_between(mesh_, a, b))
      if (mesh_.is_wire(ryosen::edge(h))) keep(ryosen::edge(h));
  if (is_whole_ && first_wires_.empty())
    for (const Edge wire : live_edges(mesh_))
      if (mesh_.is_wire(wire) && !is_single_sheet(halfedge(wire))) keep(wire);
  return keep(e);
}

bool Neighbourhood::is_first_wire(Edge e) {
  const Halfedge h = halfedge(e);
  return is_single_sheet(h) || (edge(h).faces() == 0 && first_wire(e) == e);
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
  const Star s = star(std::min(a, b));
  const StarEdge* e = s.edge_to(std::max(a, b));
  if (!e) return;
  for (std::uint32_t i = 0; i < e->faces.faces(); ++i)
    faces.push_back(mesh_.face(s.corners[s.sides[e->first_side + i] / 2]));
}

Halfedge Neighbourhood::across(Halfedge h) {
  if (is_single_sheet(h)) return mesh_.is_outside(twin(h)) ? Halfedge() : twin(h);
  const Star s = star(mesh_.from(h));
  const auto corner = std::lower_bound(s.corners.begin(), s.corners.end(), h);
  const auto side = static_cast<std::uint32_t>(2 * (corner - s.corners.begin()));
  const StarEdge& e = s.edges[s.edge_of_side[side]];
  if (e.faces.faces() != 2) return Halfedge();
  const std::uint32_t other = s.sides[e.first_side] == side ? s.sides[e.first_side + 1] : s.sides[e.first_side];
  const Halfedge other_corner = s.corners[other / 2];
  return (other & 1u) != 0 ? mesh_.prev(other_corner) : other_corner;
}

Neighbourhood::TwoSides Neighbourhood::two_sides(Edge e) {
  if (!is_first_sheet(e)) return {};
  const Halfedge half = halfedge(e), side = mesh_.is_outside(half) ? twin(half) : half;
  const Halfedge other = across(side);
  return other ? TwoSides{side, other} : TwoSides{};
}

std::uint32_t Neighbourhood::fans(Vertex v) {
  if (!is_plain(v)) return star(v).fans;
  // At most one gap: without a face the vertex is isolated or the end of one wire.
  const Halfedge h = mesh_.halfedge(v);
  return h && !(mesh_.is_outside(h) && mesh_.counter_clockwise(h) == h) ? 1 : 0;
}

glm::dvec3 Neighbourhood::normal(Face f) {
  std::array<glm::dvec3, 8> places;
  std::size_t n = 0;
  const Halfedge first = mesh_.halfedge(f);
  Halfedge h = first;
  bool all_finite = true;
  do {
    places[n] = mesh_.position(mesh_.from(h));
    all_finite = all_finite && is_finite(places[n++]);
    h = mesh_.next(h);
  } while (h != first && n < places.size());
  if (h == first && !mesh_.has_rings(f)) return all_finite ? polygon_normal({places.data(), n}) : glm::dvec3(0.0);
  const auto [known, is_new] = known_normals_.try_emplace(f, 0.0);
  if (!is_new) return known->second;
  const FacePolygon polygon(mesh_, f);
  if (polygon.is_finite()) known->second = polygon_normal(polygon.keyhole_walk());
  return known->second;
}

BoundaryStep Neighbourhood::next_boundary(BoundaryStep step) {
  const Vertex v = step.at_end ? mesh_.to(step.inside) : mesh_.from(step.inside);
  if (is_plain(v)) {
    const Halfedge outside = twin(step.inside);
    return {twin(step.at_end ? mesh_.prev(outside) : mesh_.next(outside)), step.at_end};
  }
  const Vertex other_end = point(step.at_end ? mesh_.from(step.inside) : mesh_.to(step.inside));
  const Star s = star(v);
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
