#include "ryosen/algo/remesh/features.h"

#include <algorithm>
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

Features::Kind feature_kind(const Mesh& mesh, Edge e, double least_cosine) {
  const Halfedge h = halfedge(e), t = twin(h);
  if (mesh.is_outside(h) || mesh.is_outside(t) || is_cut_on_points(mesh, h)) return Features::held;
  if (!is_finite_face(mesh, h) || !is_finite_face(mesh, t)) return Features::held;
  if (face_values_differ(mesh, mesh.face(h), mesh.face(t))) return Features::held;
  const glm::dvec3 a = unit_normal(mesh, h), b = unit_normal(mesh, t);
  if (glm::dot(a, a) > 0.5 && glm::dot(b, b) > 0.5 && glm::dot(a, b) <= least_cosine) return Features::held;
  return corner_values_differ(mesh, h, t, false) ? Features::seam : Features::none;
}

Features::Kind kind_at_seams(std::uint8_t count) {
  return count == 0 ? Features::none : count == 2 ? Features::seam : Features::seam_end;
}

}  // namespace

Features find_features(const Mesh& mesh, double angle_rad, SeamMode seams) {
  Features found;
  found.weighs_seams = seams == SeamMode::weighed;
  found.edges.assign(mesh.edge_slots(), Features::none);
  found.vertices.assign(mesh.vertex_slots(), Features::none);
  std::vector<std::uint8_t> seams_at(mesh.vertex_slots(), 0);  // up to 3
  const double least_cosine = std::cos(angle_rad);
  for (const Edge e : live_edges(mesh)) {
    const Features::Kind kind = feature_kind(mesh, e, least_cosine);
    found.edges[e.index] = kind;
    const auto [a, b] = ends(mesh, e);
    for (const Vertex v : {a, b}) {
      if (kind == Features::held) found.vertices[v.index] = Features::held;
      if (kind == Features::seam) seams_at[v.index] = static_cast<std::uint8_t>(std::min(seams_at[v.index] + 1, 3));
    }
  }
  for (const Vertex v : live_vertices(mesh)) {
    std::uint8_t& kind = found.vertices[v.index];
    if (mesh.is_isolated(v) || has_copies(mesh, v) || mesh.is_boundary(v)) kind = Features::held;
    if (kind == Features::none) kind = kind_at_seams(seams_at[v.index]);
  }
  return found;
}

}  // namespace ryosen::remesh
