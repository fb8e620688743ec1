#include "ryosen/mesh/middle.h"

#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

namespace {

glm::dvec3 middle_of_face(const Mesh& mesh, Face f) {
  const FacePolygon polygon(mesh, f);
  std::vector<CornerTriangle> triangles;
  polygon.triangulate(triangles);
  if (!triangles.empty()) {
    const CornerTriangle& t = triangles[triangles.size() / 2];
    return (polygon.places()[t[0]] + polygon.places()[t[1]] + polygon.places()[t[2]]) / 3.0;
  }
  glm::dvec3 sum(0);
  double corners = 0;
  for (const Vertex v : vertices_around(mesh, f)) sum += mesh.position(v), ++corners;
  return sum / corners;
}

}  // namespace

glm::dvec3 middle_of(const Mesh& mesh, const Element& element) {
  if (element.kind == Element::Kind::vertex) return mesh.position(element.vertex());
  if (element.kind == Element::Kind::face) return middle_of_face(mesh, element.face());
  const Halfedge h = element.kind == Element::Kind::edge ? halfedge(element.edge()) : element.halfedge();
  return 0.5 * mesh.position(mesh.from(h)) + 0.5 * mesh.position(mesh.to(h));
}

}  // namespace ryosen
