// Shared parts of the conversions between forms and Mesh: compact numbering, corner lists, and a mesh built from joined
// sides.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::forms {

// The first halfedges of the inner loops of a face; empty for ordinary faces.
std::vector<Halfedge> inner_loops(const Mesh& mesh, Face f);
// Sets them for a face that has none yet; face_halfedge must have its final length.
void set_inner_loops(MeshColumns& columns, Face f, std::span<const Halfedge> starts);

// Number of corners of the loop of a halfedge.
std::size_t corners_of_loop(const Mesh& mesh, Halfedge start);

// Whether the vertex is a copy of a point and not its representative.
bool is_further_copy(const Mesh& mesh, Vertex v);

// Compact numbers by slot, from 0, no_index for dead slots. `point` gives all copies of a point the same number.
struct Numbering {
  explicit Numbering(const Mesh& mesh);

  std::vector<std::uint32_t> vertex, point, edge, face;
  std::uint32_t vertices = 0, points = 0, edges = 0, faces = 0;

  Halfedge halfedge(Halfedge h) const {
    return h.is_none() ? h : Halfedge((edge[h.index >> 1u] << 1u) | (h.index & 1u));
  }
};

// The faces as concatenated corner lists.
struct Polygons {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> offsets{0};  // faces + 1 entries

  std::uint32_t face_count() const { return static_cast<std::uint32_t>(offsets.size() - 1); }
};
// The corners of a face.
std::vector<Vertex> vertices_of(const Polygons& polygons, Face f);
// Without inner loops; copies merged into points.
Polygons polygons_of(const Mesh& mesh, const Numbering& numbers);

// The halfedge of each corner of polygons_of.
std::vector<Halfedge> corner_halfedges(const Mesh& mesh);

// For each corner of polygons_of the corner across its side, no_index at a boundary. The mesh must have no copies and
// no rings.
std::vector<std::uint32_t> corners_across(const Mesh& mesh);

// The mesh of polygons with their sides joined as given by `across`; at most one fan of faces at each vertex.
Mesh mesh_from_sides(const Polygons& polygons, const std::vector<std::uint32_t>& across);

// The mesh of polygons that are given by coordinates alone. Corners with equal coordinates are one point, numbered by
// the first of them; +0 and -0 are equal. `polygons` is a range of ranges of places, all finite. O(n log n).
template <class Places>
Mesh mesh_from_places(const Places& polygons) {
  IndexedMesh list;
  std::map<std::array<double, 3>, std::uint32_t> number;
  for (const auto& polygon : polygons) {
    for (const glm::dvec3& p : polygon) {
      const auto [found, is_new] =
          number.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(list.positions.size()));
      if (is_new) list.positions.push_back(p);
      list.corners.push_back(found->second);
    }
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return from_indexed(std::move(list));
}

// The mesh without its dead slots, with copies and rings unchanged; without attributes.
Mesh without_gaps(const Mesh& mesh, const Numbering& numbers);

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

}  // namespace ryosen::forms
