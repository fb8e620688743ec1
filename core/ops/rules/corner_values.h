// How corner attributes (texture coordinates, normals) follow an operator.
#pragma once

#include <span>

#include "core/mesh/attribute.h"
#include "core/mesh/edit.h"

namespace ryosen {

// The corner attributes of the mesh under edit, addressed by the halfedge that leaves the corner's vertex in its face.
class CornerWriter {
 public:
  explicit CornerWriter(Edit& edit) : edit_(edit), attributes_(corner_attributes(edit.mesh())) {}

  std::size_t count() const { return attributes_.size(); }
  std::uint32_t index(std::size_t attribute, Halfedge corner) const;
  void set(std::size_t attribute, Halfedge corner, std::uint32_t index);
  // The index of a value at a + t (b - a): a or b itself at the ends, a new one between; none if one end has none.
  std::uint32_t blend(std::size_t attribute, std::uint32_t a, std::uint32_t b, double t);
  // The index of the mean of the values at some corners, one or more; none if one of them has none.
  std::uint32_t mean(std::size_t attribute, std::span<const Halfedge> at);

 private:
  Edit& edit_;
  std::vector<CornerAttribute> attributes_;
};

// Whether the values at the two ends of an edge differ between its two faces.
bool is_seam(const Mesh& mesh, Halfedge h);

// The edges (sorted) are about to go and the faces beside them to become one. Corners of several faces that thereby become
// one take the values of the corner in the face with the lowest number. To be called before the links change.
void merge_corner_values(Edit& edit, std::span<const Edge> edges_that_go);

// A new face takes the material, group and other face values of the face it was cut from.
void copy_face_values(Edit& edit, Face from, Face to);
// A new vertex takes the vertex values (colours) at a + t (b - a); columns of doubles are blended, others copied from
// a.
void blend_vertex_values(Edit& edit, Vertex a, Vertex b, double t, Vertex to);
// The same with the mean over some vertices; other columns are copied from the first.
void mean_vertex_values(Edit& edit, std::span<const Vertex> from, Vertex to);

}  // namespace ryosen
