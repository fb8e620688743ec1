#include "ryosen/algo/remesh/features.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/algo/features.h"
#include "ryosen/algo/remesh/triangle_shape.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::remesh {

namespace {

bool is_finite_face(const Mesh& mesh, Halfedge h) {
  const Corners corners = corners_of(mesh, h);
  return is_finite(corners[0]) && is_finite(corners[1]) && is_finite(corners[2]);
}

bool is_feature(const Mesh& mesh, Edge e, double least_cosine) {
  const Halfedge h = halfedge(e), t = twin(h);
  if (mesh.is_outside(h) || mesh.is_outside(t) || is_cut_on_points(mesh, h)) return true;
  if (!is_finite_face(mesh, h) || !is_finite_face(mesh, t)) return true;
  if (face_values_differ(mesh, mesh.face(h), mesh.face(t)) || corner_values_differ(mesh, h, t, false)) return true;
  const glm::dvec3 a = unit_normal(mesh, h), b = unit_normal(mesh, t);
  return glm::dot(a, a) > 0.5 && glm::dot(b, b) > 0.5 && glm::dot(a, b) <= least_cosine;
}

}  // namespace

Features find_features(const Mesh& mesh, double angle_rad) {
  Features found;
  found.edges.assign(mesh.edge_slots(), 0);
  found.vertices.assign(mesh.vertex_slots(), 0);
  const double least_cosine = std::cos(angle_rad);
  for (const Edge e : live_edges(mesh)) {
    if (!is_feature(mesh, e, least_cosine)) continue;
    found.edges[e.index] = 1;
    const auto [a, b] = ends(mesh, e);
    found.vertices[a.index] = found.vertices[b.index] = 1;
  }
  for (const Vertex v : live_vertices(mesh))
    if (mesh.is_isolated(v) || has_copies(mesh, v) || mesh.is_boundary(v)) found.vertices[v.index] = 1;
  return found;
}

}  // namespace ryosen::remesh
