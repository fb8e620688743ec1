// Updates of corner attributes (texture coordinates, normals) by operators.
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
  // The index of the value at t between those at two indices; none if one with a weight is none.
  std::uint32_t blend(std::size_t attribute, std::uint32_t a, std::uint32_t b, double t);

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

}  // namespace ryosen
