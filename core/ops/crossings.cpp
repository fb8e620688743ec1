#include "core/ops/crossings.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <unordered_set>

#include "core/geometry/triangles_cross.h"
#include "core/geometry/triangulate.h"
#include "core/mesh/circulate.h"

namespace ryosen {

namespace {

// Beyond this the search would be felt under the pointer.
constexpr std::size_t most_corners = 5000;

// A face as triangles, with the box around it.
struct Shape {
  Face face;
  std::vector<std::array<glm::dvec3, 3>> triangles;
  glm::dvec3 lowest, highest;

  bool is_apart_from(const Shape& other) const {
    for (int axis = 0; axis < 3; ++axis)
      if (highest[axis] < other.lowest[axis] || other.highest[axis] < lowest[axis]) return true;
    return false;
  }
};

Shape shape_of(const Mesh& mesh, Face f) {
  std::vector<glm::dvec3> corners;
  for (Vertex v : vertices_around(mesh, f)) corners.push_back(mesh.position(v));
  Shape shape{f, {}, corners[0], corners[0]};
  for (const glm::dvec3& p : corners) {
    shape.lowest = glm::min(shape.lowest, p);
    shape.highest = glm::max(shape.highest, p);
  }
  std::vector<CornerTriangle> triangles;
  triangulate(corners, triangles);
  for (const CornerTriangle& t : triangles) shape.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  return shape;
}

bool cross(const Shape& a, const Shape& b) {
  if (a.is_apart_from(b)) return false;
  for (const auto& s : a.triangles)
    for (const auto& t : b.triangles)
      if (triangles_cross(s, t)) return true;
  return false;
}

std::vector<Face> sorted(std::vector<Face> faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// The faces and those within two rings of them, each star visited once; nothing once they have too many corners.
std::vector<Face> two_rings_around(const Mesh& mesh, const std::vector<Face>& faces) {
  std::vector<Face> all;
  std::unordered_set<Face> seen;
  std::unordered_set<Vertex> stars;
  std::size_t corners = 0;
  const auto add = [&](Face f) {
    if (!f || !seen.insert(f).second) return;
    all.push_back(f);
    for ([[maybe_unused]] Halfedge h : halfedges_around(mesh, f))
      if (++corners > most_corners) break;
  };
  for (Face f : faces) add(f);
  std::size_t begin = 0;
  for (int ring = 0; ring < 2; ++ring) {
    const std::size_t end = all.size();
    for (; begin < end; ++begin) {
      for (Vertex v : vertices_around(mesh, all[begin])) {
        if (!stars.insert(v).second) continue;
        for (Face g : faces_around(mesh, v)) {
          add(g);
          if (corners > most_corners) return {};
        }
      }
    }
  }
  return all;
}

}  // namespace

std::vector<Crossing> crossings_near(const Mesh& mesh, std::span<const Face> faces) {
  std::vector<Face> live;
  for (Face f : faces)
    if (mesh.exists(f) && mesh.is_alive(f)) live.push_back(f);
  live = sorted(std::move(live));
  std::vector<Shape> shapes;
  for (Face f : two_rings_around(mesh, live)) shapes.push_back(shape_of(mesh, f));
  std::vector<Crossing> found;
  for (const Shape& a : shapes) {
    if (!std::binary_search(live.begin(), live.end(), a.face)) continue;
    for (const Shape& b : shapes) {
      const bool met_from_there = b.face < a.face && std::binary_search(live.begin(), live.end(), b.face);
      if (a.face != b.face && !met_from_there && cross(a, b))
        found.emplace_back(std::min(a.face, b.face), std::max(a.face, b.face));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace ryosen
