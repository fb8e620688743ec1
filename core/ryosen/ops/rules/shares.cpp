#include "ryosen/ops/rules/shares.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

std::vector<double> areas_of(const Mesh& mesh, std::span<const Face> faces) {
  std::vector<double> areas;
  FacePolygon polygon;
  for (const Face f : faces) {
    polygon.read(mesh, f);
    areas.push_back(glm::length(vector_area(polygon.keyhole_walk())));
  }
  return areas;
}

std::vector<double> lengths_of(const Mesh& mesh, std::span<const Edge> edges) {
  std::vector<double> lengths;
  for (const Edge e : edges) {
    const auto [a, b] = ends(mesh, e);
    lengths.push_back(glm::distance(mesh.position(a), mesh.position(b)));
  }
  return lengths;
}

std::vector<double> lengths_of_parts(double along) { return {std::abs(along), std::abs(1 - along)}; }

}  // namespace ryosen
