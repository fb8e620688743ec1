// What the forms share on their way from and to Mesh: numbers without gaps, corner lists, and a mesh made from sides.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen::forms {

// The first halfedges of the inner loops of a face; empty for ordinary faces.
std::vector<Halfedge> inner_loops(const Mesh& mesh, Face f);
// Gives them to a face that has none yet; face_halfedge must have its length.
void set_inner_loops(MeshColumns& columns, Face f, std::span<const Halfedge> starts);

// How many corners the loop of a halfedge has.
std::size_t corners_of_loop(const Mesh& mesh, Halfedge start);

// Whether the vertex is a copy of a point that a smaller number names.
bool is_further_copy(const Mesh& mesh, Vertex v);

// Numbers from 0 without gaps by slot, no_index for what is not alive. `point` gives all copies of a point one number.
struct Numbering {
  explicit Numbering(const Mesh& mesh);

  std::vector<std::uint32_t> vertex, point, edge, face;
  std::uint32_t vertices = 0, points = 0, edges = 0, faces = 0;

  Halfedge halfedge(Halfedge h) const {
    return h.is_none() ? h : Halfedge((edge[h.index >> 1u] << 1u) | (h.index & 1u));
  }
};

// The faces as lists of numbers, face after face.
struct Polygons {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> offsets{0};  // faces + 1 entries

  std::uint32_t face_count() const { return static_cast<std::uint32_t>(offsets.size() - 1); }
};
// Without inner loops; copies merged into points.
Polygons polygons_of(const Mesh& mesh, const Numbering& numbers);

// For each corner of polygons_of the corner on the other side of its side, no_index on a boundary. The mesh must have no
// copies and no rings.
std::vector<std::uint32_t> corners_across(const Mesh& mesh, const Numbering& numbers, const Polygons& polygons);

// The mesh of polygons whose sides are joined as `across` says, one fan of faces at each vertex.
Mesh mesh_from_sides(const Polygons& polygons, const std::vector<std::uint32_t>& across);

// The mesh with its dead slots left out, copies and rings as they are; without attributes.
Mesh without_gaps(const Mesh& mesh, const Numbering& numbers);

// Bytes of a vector's elements.
template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

}  // namespace ryosen::forms
