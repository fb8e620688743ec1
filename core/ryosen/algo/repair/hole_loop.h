// The loop of a hole with what surrounds it, and the patch for it, as plain lists beside the mesh.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/triangulate.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Which points are joined by edges, the lower first; sorted.
using JoinedCorners = std::vector<std::pair<Vertex, Vertex>>;

// The faces at a hole's corners. Vertices are numbered: first the corners of the loop, then those in `places`.
struct HoleSurroundings {
  std::vector<double> spacing;            // by corner: the mean length of its edges, but no more than its two sides
  std::vector<std::uint8_t> is_open;      // by corner: whether it has another gap, or faces that are not in `triangles`
  std::vector<glm::dvec3> places;         // of vertices beside the loop
  std::vector<CornerTriangle> triangles;  // of the faces; of one with many corners, those at the loop
};

// Whether an edge of a patch joins two of the corners of the loop, its first vertices, that are not neighbours.
inline bool is_chord(std::uint32_t a, std::uint32_t b, std::uint32_t corners) {
  const auto [low, high] = std::minmax(a, b);
  return high < corners && high != low + 1 && (low != 0 || high != corners - 1);
}

struct HoleLoop {
  std::vector<Halfedge> sides;      // halfedges without a face, each from its corner to the next
  std::vector<Vertex> points;       // by corner: its point
  std::vector<glm::dvec3> places;   // by corner; finite
  std::vector<glm::dvec3> normals;  // of the face across each side; unit, or zero if unknown
  HoleSurroundings around;
  const JoinedCorners* joined = nullptr;

  std::uint32_t size() const { return static_cast<std::uint32_t>(places.size()); }
  // Whether an edge may join two corners that are not neighbours.
  bool may_join(std::uint32_t i, std::uint32_t k) const {
    return !std::binary_search(joined->begin(), joined->end(),
                               JoinedCorners::value_type(std::minmax(points[i], points[k])));
  }
  // Whether no side of a triangle of a patch joins corners by an edge that exists, but those along the loop.
  bool allows(const CornerTriangle& t) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (is_chord(t[k], t[(k + 1) % 3], size()) && !may_join(t[k], t[(k + 1) % 3])) return false;
    return true;
  }
  // Of corners.
  bool is_flat(const CornerTriangle& t) const { return are_collinear(places[t[0]], places[t[1]], places[t[2]]); }
};

// Unit normals of faces, zero where there is none: by need, each computed once, since a large face may lie beside many
// holes.
using NormalsOfFaces = std::unordered_map<Face, glm::dvec3>;

// Reads the loop from the corner at `start`.
HoleLoop read_hole(const Mesh& mesh, Halfedge start, const JoinedCorners& joined, NormalsOfFaces& normals);

struct HolePatch {
  std::uint32_t corners = 0;              // of the loop; they are the first vertices
  std::vector<glm::dvec3> places;         // of all vertices
  std::vector<CornerTriangle> triangles;  // oriented along the loop
  // By new vertex: the three vertices in the middle of which it was made; none for one amid the whole loop.
  std::vector<CornerTriangle> parents;
  std::vector<double> spacing;  // by vertex: the wanted length of its edges; once it has been refined

  bool is_flat(const CornerTriangle& t) const { return are_collinear(places[t[0]], places[t[1]], places[t[2]]); }
  std::uint32_t new_vertices() const { return static_cast<std::uint32_t>(places.size()) - corners; }
};

}  // namespace ryosen
