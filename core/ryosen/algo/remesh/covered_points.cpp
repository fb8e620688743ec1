#include "ryosen/algo/remesh/covered_points.h"

#include <algorithm>
#include <cmath>

namespace ryosen::remesh {

CoveredPoints::CoveredPoints(const Mesh& mesh, const Features& features, double spacing) {
  first_.assign(mesh.face_slots(), no_index);
  FaceNormals area_normals(mesh.face_slots(), glm::dvec3(0));
  for (Face f(0); f.index < mesh.face_slots(); ++f.index)
    if (mesh.is_alive(f)) area_normals[f.index] = area_normal(corners_of(mesh, mesh.halfedge(f)));
  points_.reserve(2 * mesh.live().vertices);
  for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index)
    if (mesh.is_alive(v) && !features.vertices[v.index]) add_vertex(mesh, area_normals, v);
  for (Edge e(0); e.index < mesh.edge_slots(); ++e.index)
    if (mesh.is_alive(e) && !features.edges[e.index]) add_edge(mesh, area_normals, e, spacing);
}

void CoveredPoints::add_vertex(const Mesh& mesh, const FaceNormals& area_normals, Vertex v) {
  glm::dvec3 sum(0);
  double size = 0, most = -2;
  Face best;
  for (const Halfedge h : outgoing(mesh, v)) {
    const glm::dvec3& area = area_normals[mesh.face(h).index];
    sum += area;
    size += glm::length(area);
  }
  const glm::dvec3 normal = glm::length(sum) > 0.3 * size ? unit_or_zero(sum) : glm::dvec3(0);
  for (const Halfedge h : outgoing(mesh, v)) {
    const glm::dvec3& area = area_normals[mesh.face(h).index];
    if (const double cosine = glm::dot(unit_or_zero(area), normal); cosine > most) {
      most = cosine;
      best = mesh.face(h);
    }
  }
  points_.push_back({mesh.position(v), most > least_facing ? normal : glm::dvec3(0), 0, no_index});
  give(static_cast<std::uint32_t>(points_.size() - 1), best);
}

void CoveredPoints::add_edge(const Mesh& mesh, const FaceNormals& area_normals, Edge e, double spacing) {
  const Halfedge h = halfedge(e);
  const glm::dvec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
  const auto parts = static_cast<std::uint32_t>(std::clamp(std::ceil(glm::distance(a, b) / spacing), 1.0, 10000.0));
  if (parts == 1) return;
  const glm::dvec3 normal = unit_or_zero(unit_or_zero(area_normals[mesh.face(h).index]) +
                                         unit_or_zero(area_normals[mesh.face(twin(h)).index]));
  for (std::uint32_t i = 1; i < parts; ++i) {
    const double along = double(i) / parts;
    points_.push_back({(1 - along) * a + along * b, normal, 0, no_index});
    give(static_cast<std::uint32_t>(points_.size() - 1), mesh.face(h));
  }
}

void CoveredPoints::give(std::uint32_t point, Face f) {
  make_room(f.index + 1);
  points_[point].next = first_[f.index];
  first_[f.index] = point;
}

}  // namespace ryosen::remesh
