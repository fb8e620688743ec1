#include "core/highlights/creases.h"

#include <glm/geometric.hpp>

namespace ryosen {

bool is_crease(Neighbourhood& around, Edge e) {
  const auto [h, o] = around.two_sides(e);
  if (!h) return false;
  const Mesh& mesh = around.mesh();
  if (mesh.face(h) == mesh.face(o)) return false;
  const glm::dvec3 a = around.normal(mesh.face(h)), b = around.normal(mesh.face(o));
  if (a == glm::dvec3(0.0) || b == glm::dvec3(0.0)) return false;
  const double cosine = glm::dot(a, b);
  return (around.run_alike(h, o) ? -cosine : cosine) < crease_cosine;
}

}  // namespace ryosen
