// Updates of attributes (texture coordinates, normals, face and vertex values) by operators.
#pragma once

#include <functional>
#include <span>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Write access to the corner attributes of the edited mesh. A corner is the halfedge that leaves its vertex along its
// face.
class CornerWriter {
 public:
  explicit CornerWriter(Edit& edit) : edit_(edit), attributes_(corner_attributes(edit.mesh())) {}

  std::size_t count() const { return attributes_.size(); }
  std::uint32_t index(std::size_t attribute, Halfedge corner) const;
  void set(std::size_t attribute, Halfedge corner, std::uint32_t index);
  // The index of the value a + t (b - a): a or b itself at the ends, else a new value; none if one end has none.
  std::uint32_t blend(std::size_t attribute, std::uint32_t a, std::uint32_t b, double t);
  // The index of the mean of the values at one or more corners; none if one of them has none.
  std::uint32_t mean(std::size_t attribute, std::span<const Halfedge> at);

 private:
  Edit& edit_;
  std::vector<CornerAttribute> attributes_;
};

// Whether the values at the two ends of an edge differ between its two faces.
bool is_seam(const Mesh& mesh, Halfedge h);

// Call before removing these edges (sorted) and merging the faces at them. Corners that will be merged take the values
// of the corner in the lowest-numbered face; `number` says by which number a face goes.
using NumberOfFace = std::function<std::uint32_t(Face)>;
void merge_corner_values(
    Edit& edit, std::span<const Edge> edges_that_go, const NumberOfFace& number = [](Face f) { return f.index; });

// Copies the material, group and other face values.
void copy_face_values(Edit& edit, Face from, Face to);
// Sets the vertex values (colours) of a new vertex to a + t (b - a); columns of doubles are interpolated, others copied
// from a.
void blend_vertex_values(Edit& edit, Vertex a, Vertex b, double t, Vertex to);
// The same with the mean over several vertices; other columns are copied from the first.
void mean_vertex_values(Edit& edit, std::span<const Vertex> from, Vertex to);

}  // namespace ryosen
