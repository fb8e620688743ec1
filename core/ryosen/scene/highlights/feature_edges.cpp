#include "ryosen/scene/highlights/feature_edges.h"

#include <glm/geometric.hpp>

#include "ryosen/mesh/attribute.h"

namespace ryosen {

double cosine_of_bend(Neighbourhood& around, Halfedge a, Halfedge b) {
  const Mesh& mesh = around.mesh();
  if (mesh.face(a) == mesh.face(b)) return 1;
  const glm::dvec3 n = around.normal(mesh.face(a)), m = around.normal(mesh.face(b));
  if (n == glm::dvec3(0.0) || m == glm::dvec3(0.0)) return 1;
  const double cosine = glm::dot(n, m);
  return around.run_alike(a, b) ? -cosine : cosine;
}

bool bends(Neighbourhood& around, Edge e, double cosine_of_angle) {
  const auto [h, o] = around.two_sides(e);
  return h && cosine_of_bend(around, h, o) < cosine_of_angle;
}

bool is_seam_edge(Neighbourhood& around, Edge e) {
  const Mesh& mesh = around.mesh();
  if (mesh.attributes().empty()) return false;
  const auto [h, o] = around.two_sides(e);
  return h && corner_values_differ(mesh, h, o, around.run_alike(h, o));
}

}  // namespace ryosen
