#include "ryosen/analysis/measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_set>

#include "ryosen/geometry/closest.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

constexpr double no_measure = std::numeric_limits<double>::quiet_NaN();

using SortOfElement = Element::Kind;
using MeasuredPiece = std::vector<glm::dvec3>;

const Text distance_name{"distance", "距離"}, length_name{"length", "長さ"}, angle_name{"angle", "角度"},
    area_name{"area", "面積"}, perimeter_name{"perimeter", "周長"}, volume_name{"volume", "体積"};

std::optional<Edge> edge_of(const Element& e) {
  if (e.kind == SortOfElement::edge) return e.edge();
  if (e.kind == SortOfElement::halfedge) return edge(e.halfedge());
  return std::nullopt;
}

// Its point, its segment, or its triangles.
std::vector<MeasuredPiece> pieces_of(const Mesh& mesh, const Element& e) {
  if (e.kind == SortOfElement::vertex) return {{mesh.position(e.vertex())}};
  if (const auto one = edge_of(e)) {
    const auto [a, b] = ends(mesh, *one);
    return {{mesh.position(a), mesh.position(b)}};
  }
  const FacePolygon polygon(mesh, e.face());
  std::vector<CornerTriangle> triangles;
  if (polygon.is_finite()) polygon.triangulate(triangles);
  std::vector<MeasuredPiece> pieces;
  for (const CornerTriangle& t : triangles)
    pieces.push_back({polygon.places()[t[0]], polygon.places()[t[1]], polygon.places()[t[2]]});
  return pieces;
}

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * degrees_per_radian;
}

// From the point that two edges share, else between their lines, at most 90.
double angle_of_edges(const Mesh& mesh, Edge a, Edge b) {
  for (Halfedge h : {halfedge(a, 0), halfedge(a, 1)})
    for (Halfedge o : {halfedge(b, 0), halfedge(b, 1)})
      if (point(mesh, mesh.from(h)) == point(mesh, mesh.from(o)))
        return angle_deg(mesh.position(mesh.to(h)) - mesh.position(mesh.from(h)),
                         mesh.position(mesh.to(o)) - mesh.position(mesh.from(o)));
  const auto along = [&](Edge e) { return mesh.position(ends(mesh, e).second) - mesh.position(ends(mesh, e).first); };
  const double angle = angle_deg(along(a), along(b));
  return std::min(angle, 180 - angle);
}

// Through the body at the edge that two faces alone share, else between their normals; none without area.
std::optional<double> angle_of_faces(const Mesh& mesh, Face f, Face g) {
  Neighbourhood around(mesh);
  for (Halfedge h : halfedges_around(mesh, f))
    if (const Halfedge other = around.across(h); other && mesh.face(other) == g)
      for (Edge e : {edge(h), edge(other)})
        if (const double angle = dihedral_angle_deg(around, e); !std::isnan(angle)) return angle;
  const glm::dvec3 n = around.normal(f), m = around.normal(g);
  if (n == glm::dvec3(0.0) || m == glm::dvec3(0.0)) return std::nullopt;
  return angle_deg(n, m);
}

Measurement of_two(const Mesh& mesh, const Element& a, const Element& b) {
  std::optional<ShortestWay> best;
  const std::vector<MeasuredPiece> from = pieces_of(mesh, a), to = pieces_of(mesh, b);
  for (const MeasuredPiece& p : from)
    for (const MeasuredPiece& q : to)
      if (const ShortestWay way = shortest_way(p, q); !best || way.length < best->length) best = way;
  if (!best || !std::isfinite(best->length)) return {};
  Measurement found{{{distance_name, MapUnit::length, best->length}}, {best->from, best->to}};
  const auto e = edge_of(a), o = edge_of(b);
  if (e && o) found.values.push_back({angle_name, MapUnit::degrees, angle_of_edges(mesh, *e, *o)});
  if (a.kind == SortOfElement::face && b.kind == SortOfElement::face)
    if (const auto angle = angle_of_faces(mesh, a.face(), b.face()))
      found.values.push_back({angle_name, MapUnit::degrees, *angle});
  return found;
}

Measurement of_three(const Mesh& mesh, std::span<const Element> vertices) {
  const auto place = [&](std::size_t i) { return mesh.position(vertices[i].vertex()); };
  const glm::dvec3 a = place(0), corner = place(1), b = place(2);
  if (!is_finite(a) || !is_finite(corner) || !is_finite(b)) return {};
  return {{{angle_name, MapUnit::degrees, angle_deg(a - corner, b - corner)},
           {distance_name, MapUnit::length, glm::distance(a, corner)},
           {distance_name, MapUnit::length, glm::distance(corner, b)}},
          {a, corner, b}};
}

// The edges with faces of the set on one side alone, each with how often they have one, on points.
struct Rim {
  double length = 0;
  bool is_closed = true;  // the set closes in itself, consistently turned
};
Rim rim_of(const Mesh& mesh, const std::set<std::uint32_t>& faces) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> sides;  // forward and backward
  Rim rim;
  for (const std::uint32_t f : faces)
    for (Halfedge h : halfedges_around(mesh, Face(f))) {
      const std::uint32_t a = point(mesh, mesh.from(h)).index, b = point(mesh, mesh.to(h)).index;
      auto& side = sides[std::minmax(a, b)];
      ++(a < b ? side.first : side.second);
    }
  for (const auto& [ends_of_side, counts] : sides) {
    if (counts.first != counts.second) rim.is_closed = false;
    if (counts.first + counts.second == 1)
      rim.length +=
          glm::distance(mesh.position(Vertex(ends_of_side.first)), mesh.position(Vertex(ends_of_side.second)));
  }
  return rim;
}

Measurement of_all(const Mesh& mesh, std::span<const Element> elements) {
  std::set<std::uint32_t> edges, faces;
  for (const Element& e : elements) {
    if (const auto one = edge_of(e)) edges.insert(one->index);
    if (e.kind == SortOfElement::face) faces.insert(e.index);
  }
  Measurement found;
  double length = 0, area = 0, volume = 0;
  for (const std::uint32_t e : edges) length += edge_length(mesh, Edge(e));
  if (!edges.empty()) found.values.push_back({length_name, MapUnit::length, length});
  std::optional<glm::dvec3> apex;
  for (const std::uint32_t f : faces) {
    const std::vector<glm::dvec3> walk = FacePolygon(mesh, Face(f)).keyhole_walk();
    if (!apex) apex = walk[0];
    area += polygon_area(walk);
    volume += polygon_volume(walk, *apex);
  }
  if (!faces.empty()) {
    const Rim rim = rim_of(mesh, faces);
    found.values.push_back({area_name, MapUnit::area, area});
    if (rim.is_closed)
      found.values.push_back({volume_name, MapUnit::none, volume});
    else
      found.values.push_back({perimeter_name, MapUnit::length, rim.length});
  }
  if (std::any_of(found.values.begin(), found.values.end(), [](const auto& v) { return !std::isfinite(v.value); }))
    return {};
  if (edges.size() == 1 && faces.empty()) {
    const auto [a, b] = ends(mesh, Edge(*edges.begin()));
    found.path = {mesh.position(a), mesh.position(b)};
  }
  return found;
}

}  // namespace

double edge_length(const Mesh& mesh, Edge e) {
  const auto [a, b] = ends(mesh, e);
  return glm::distance(mesh.position(a), mesh.position(b));
}

double mean_edge_length(const Mesh& mesh) {
  double sum = 0, count = 0;
  for (const Edge e : live_edges(mesh)) {
    const double length = edge_length(mesh, e);
    if (!std::isfinite(length)) continue;
    sum += length;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

std::uint32_t valence(const Mesh& mesh, Vertex v) {
  if (!has_copies(mesh, v)) {
    std::uint32_t edges = 0;
    for ([[maybe_unused]] Halfedge h : outgoing(mesh, v)) ++edges;
    return edges;
  }
  std::unordered_set<std::uint32_t> points;
  for_each_copy(mesh, v, [&](Vertex copy) {
    for (Vertex other : neighbours(mesh, copy)) points.insert(point(mesh, other).index);
  });
  return static_cast<std::uint32_t>(points.size());
}

double dihedral_angle_deg(Neighbourhood& around, Edge e) {
  const auto [h, o] = around.two_sides(e);
  if (!h) return no_measure;
  const Mesh& mesh = around.mesh();
  const glm::dvec3 n = around.normal(mesh.face(h));
  const glm::dvec3 m = around.run_alike(h, o) ? -around.normal(mesh.face(o)) : around.normal(mesh.face(o));
  if (n == glm::dvec3(0.0) || m == glm::dvec3(0.0)) return no_measure;
  const glm::dvec3 along = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h)), turn = glm::cross(n, m);
  const double bend = std::atan2(glm::length(turn), glm::dot(n, m)) * degrees_per_radian;
  return glm::dot(turn, along) > 0 ? 180 - bend : 180 + bend;
}

CornerAngles corner_angles(Neighbourhood& around, Face f) {
  const Mesh& mesh = around.mesh();
  const bool may_point_in = !is_triangle(mesh, mesh.halfedge(f));
  const glm::dvec3 normal = may_point_in ? around.normal(f) : glm::dvec3(0.0);
  CornerAngles angles{std::numeric_limits<double>::infinity(), 0};
  for (Halfedge h : halfedges_around(mesh, f)) {
    const glm::dvec3 corner = mesh.position(mesh.from(h));
    const glm::dvec3 out = mesh.position(mesh.to(h)) - corner, in = mesh.position(mesh.from(mesh.prev(h))) - corner;
    const glm::dvec3 turn = glm::cross(out, in);
    double angle = std::atan2(glm::length(turn), glm::dot(out, in)) * degrees_per_radian;
    if (glm::dot(turn, normal) < 0) angle = 360 - angle;
    if (!(glm::dot(out, out) > 0 && glm::dot(in, in) > 0) || std::isnan(angle)) return {no_measure, no_measure};
    angles.smallest_deg = std::min(angles.smallest_deg, angle);
    angles.largest_deg = std::max(angles.largest_deg, angle);
  }
  return angles;
}

double face_area(const Mesh& mesh, Face f) { return polygon_area(FacePolygon(mesh, f).keyhole_walk()); }

double aspect_ratio(const Mesh& mesh, Face f) {
  if (mesh.first_ring(f) != no_index) return no_measure;
  double longest = 0, perimeter = 0;
  std::uint32_t corners = 0;
  for (Edge e : edges_around(mesh, f)) {
    const double length = edge_length(mesh, e);
    longest = std::max(longest, length);
    perimeter += length;
    ++corners;
  }
  const double area = face_area(mesh, f);
  if (corners < 3 || !(area > 0)) return no_measure;
  return longest * 0.5 * perimeter / (2 * std::tan(std::numbers::pi / corners) * area);
}

double distance_from_plane(Neighbourhood& around, Face f) {
  const Mesh& mesh = around.mesh();
  if (is_triangle(mesh, mesh.halfedge(f)) && mesh.first_ring(f) == no_index) return 0;
  const glm::dvec3 normal = around.normal(f);
  if (normal == glm::dvec3(0.0)) return no_measure;
  const FacePolygon polygon(mesh, f);
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& place : polygon.places()) middle += place / double(polygon.places().size());
  double farthest = 0;
  for (const glm::dvec3& place : polygon.places())
    farthest = std::max(farthest, std::abs(glm::dot(place - middle, normal)));
  return farthest;
}

Measurement measure(const Mesh& mesh, std::span<const Element> elements) {
  const auto is_vertex = [](const Element& e) { return e.kind == SortOfElement::vertex; };
  if (elements.size() == 2) return of_two(mesh, elements[0], elements[1]);
  if (elements.size() == 3 && std::all_of(elements.begin(), elements.end(), is_vertex)) return of_three(mesh, elements);
  return of_all(mesh, elements);
}

}  // namespace ryosen
