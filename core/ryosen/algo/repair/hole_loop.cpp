#include "ryosen/algo/repair/hole_loop.h"

#include <glm/geometric.hpp>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

namespace {

// A face with more corners is represented by its corners at the loop alone, so that many holes may lie in one face.
constexpr std::size_t most_corners_read = 16;

bool is_small(const Mesh& m, Face f) {
  if (m.has_rings(f)) return false;
  Halfedge h = m.halfedge(f);
  for (std::size_t corners = 0; corners <= most_corners_read; ++corners) {
    h = m.next(h);
    if (h == m.halfedge(f)) return true;
  }
  return false;
}

const glm::dvec3& normal_of(const Mesh& mesh, Face f, NormalsOfFaces& known) {
  const auto [at, is_new] = known.emplace(f, glm::dvec3(0.0));
  if (is_new) {
    const FacePolygon polygon(mesh, f);
    if (polygon.is_finite()) at->second = polygon_normal(polygon.keyhole_walk());
  }
  return at->second;
}

class SurroundingsReader {
 public:
  SurroundingsReader(const Mesh& m, HoleLoop& hole, NormalsOfFaces& normals) : m_(m), hole_(hole), normals_(normals) {
    for (Halfedge h : hole.sides) number_.emplace(m.from(h), static_cast<std::uint32_t>(number_.size()));
  }

  void run() {
    for (std::uint32_t i = 0; i < hole_.size(); ++i) read_corner(i);
    sort_unique(faces_);
    for (Face f : faces_) add_triangles(f);
  }

 private:
  HoleSurroundings& around() { return hole_.around; }

  void read_corner(std::uint32_t i) {
    double sum = 0;
    std::size_t edges = 0, gaps = 0;
    around().is_open.push_back(false);
    for (Halfedge h : outgoing(m_, m_.from(hole_.sides[i]))) {
      const glm::dvec3& end = m_.position(m_.to(h));
      if (is_finite(end)) {
        sum += glm::distance(hole_.places[i], end);
        ++edges;
      }
      gaps += m_.is_outside(h);
      if (m_.is_outside(h)) continue;
      if (is_small(m_, m_.face(h)))
        faces_.push_back(m_.face(h));
      else
        add_corner(i, h);
    }
    const double mean = edges > 0 ? sum / static_cast<double>(edges) : 0;
    around().spacing.push_back(std::min(mean, length_of_sides(i)));
    if (gaps > 1) around().is_open[i] = true;
  }

  // Of the two at a corner together.
  double length_of_sides(std::uint32_t i) const {
    const std::uint32_t before = (i + hole_.size() - 1) % hole_.size(), after = (i + 1) % hole_.size();
    return glm::distance(hole_.places[before], hole_.places[i]) + glm::distance(hole_.places[i], hole_.places[after]);
  }

  std::uint32_t number_of(Vertex v) {
    const auto [at, is_new] = number_.emplace(v, static_cast<std::uint32_t>(number_.size()));
    if (is_new) around().places.push_back(m_.position(v));
    return at->second;
  }

  // The triangle at a corner of a large face, if the corner is convex.
  void add_corner(std::uint32_t i, Halfedge h) {
    const Vertex before = m_.from(m_.prev(h)), after = m_.to(h);
    const glm::dvec3 &at = hole_.places[i], &p = m_.position(before), &q = m_.position(after);
    if (is_finite(p) && is_finite(q) && glm::dot(glm::cross(q - at, p - at), normal_of(m_, m_.face(h), normals_)) > 0)
      around().triangles.push_back({number_of(before), i, number_of(after)});
    else
      around().is_open[i] = true;
  }

  void add_triangles(Face f) {
    polygon_.read(m_, f);
    if (!polygon_.is_finite()) return;
    polygon_.triangulate(triangles_);
    for (const CornerTriangle& t : triangles_) {
      const auto number = [&](std::size_t k) { return number_of(m_.from(polygon_.corners()[t[k]])); };
      around().triangles.push_back({number(0), number(1), number(2)});
    }
  }

  const Mesh& m_;
  HoleLoop& hole_;
  NormalsOfFaces& normals_;
  std::unordered_map<Vertex, std::uint32_t> number_;
  std::vector<Face> faces_;
  FacePolygon polygon_;
  std::vector<CornerTriangle> triangles_;
};

}  // namespace

HoleLoop read_hole(const Mesh& mesh, Halfedge start, const JoinedCorners& joined, NormalsOfFaces& normals) {
  HoleLoop hole;
  hole.joined = &joined;
  for (Halfedge h : loop(mesh, start)) {
    hole.sides.push_back(h);
    hole.points.push_back(point(mesh, mesh.from(h)));
    hole.places.push_back(mesh.position(mesh.from(h)));
    const Face across = mesh.face(twin(h));
    hole.normals.push_back(across ? normal_of(mesh, across, normals) : glm::dvec3(0.0));
  }
  SurroundingsReader(mesh, hole, normals).run();
  return hole;
}

}  // namespace ryosen
