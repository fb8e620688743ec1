#include "ryosen/analysis/measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <unordered_set>

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

namespace {

constexpr double no_measure = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double edge_length(const Mesh& mesh, Edge e) {
  const auto [a, b] = ends(mesh, e);
  return glm::distance(mesh.position(a), mesh.position(b));
}

double mean_edge_length(const Mesh& mesh) {
  double sum = 0, count = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const double length = edge_length(mesh, Edge(i));
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

}  // namespace ryosen
