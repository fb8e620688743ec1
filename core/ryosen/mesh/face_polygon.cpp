#include "ryosen/mesh/face_polygon.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

void FacePolygon::read(const Mesh& mesh, Face f) {
  corners_.clear();
  places_.clear();
  loop_ends_.clear();
  for_each_loop(mesh, f, [&](Halfedge start) {
    for (Halfedge h : loop(mesh, start)) {
      corners_.push_back(h);
      places_.push_back(mesh.position(mesh.from(h)));
    }
    loop_ends_.push_back(static_cast<std::uint32_t>(corners_.size()));
  });
}

std::vector<std::span<const glm::dvec3>> FacePolygon::loops() const {
  std::vector<std::span<const glm::dvec3>> loops;
  std::uint32_t begin = 0;
  for (std::uint32_t end : loop_ends_) {
    loops.push_back(std::span(places_).subspan(begin, end - begin));
    begin = end;
  }
  return loops;
}

bool FacePolygon::is_finite() const {
  return std::all_of(places_.begin(), places_.end(), [](const glm::dvec3& p) { return ryosen::is_finite(p); });
}

void FacePolygon::move(const Mesh& mesh, Vertex v, const glm::dvec3& place) {
  for (std::size_t i = 0; i < corners_.size(); ++i)
    if (same_point(mesh, mesh.from(corners_[i]), v)) places_[i] = place;
}

void FacePolygon::move(Halfedge corner, const glm::dvec3& place) {
  const auto at = std::find(corners_.begin(), corners_.end(), corner);
  places_[static_cast<std::size_t>(at - corners_.begin())] = place;
}

void FacePolygon::triangulate(std::vector<CornerTriangle>& out) const {
  if (loop_ends_.size() == 1) return ryosen::triangulate(places_, out);
  triangulate_loops(loops(), out);
}

std::uint32_t FacePolygon::next(std::uint32_t corner) const {
  const auto end = std::upper_bound(loop_ends_.begin(), loop_ends_.end(), corner);
  if (corner + 1 < *end) return corner + 1;
  return end == loop_ends_.begin() ? 0 : *(end - 1);
}

bool FacePolygon::is_side(std::uint32_t first, std::uint32_t second) const { return next(first) == second; }

std::vector<glm::dvec3> FacePolygon::keyhole_walk() const {
  std::vector<glm::dvec3> walk(places_.begin(), places_.begin() + loop_ends_.front());
  for (std::size_t ring = 1; ring < loop_ends_.size(); ++ring) {
    walk.push_back(places_.front());
    walk.insert(walk.end(), places_.begin() + loop_ends_[ring - 1], places_.begin() + loop_ends_[ring]);
    walk.push_back(places_[loop_ends_[ring - 1]]);
  }
  return walk;
}

std::vector<glm::dvec3> measured_walk(const Mesh& mesh, Face f) {
  CornerLoops lists;
  for_each_loop(mesh, f, [&](Halfedge start) {
    std::vector<std::uint32_t> points;
    for (Halfedge h : loop(mesh, start)) points.push_back(point(mesh, mesh.from(h)).index);
    lists.add(points);
  });
  std::vector<std::vector<std::uint32_t>> loops;
  if (const auto parts = take_out_bridges(lists)) loops = normal_form(lists, *parts);
  std::vector<glm::dvec3> walk;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (i > 0) walk.push_back(mesh.position(Vertex(loops[0][0])));
    for (std::uint32_t p : loops[i]) walk.push_back(mesh.position(Vertex(p)));
    if (i > 0) walk.push_back(mesh.position(Vertex(loops[i][0])));
  }
  return walk;
}

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
