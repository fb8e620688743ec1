// Values of a vertex that lies somewhere on a face.
#pragma once

#include "ryosen/algo/remesh/target.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/edit.h"

namespace ryosen::remesh {

// All of one corner.
Target::Share share_of_corner(const Mesh& mesh, Halfedge corner);

// Writes what lies on faces of a mesh of triangles as it was before the edit, which has only added to its pools.
class ShareWriter {
 public:
  ShareWriter(Edit& edit, const Mesh& before) : edit_(edit), before_(before), attributes_(corner_attributes(before)) {}

  // The vertex, and all its corners alike, get the values there: linear within the face, but those that are no numbers
  // are of the corner with the largest share. A corner without a value makes it none.
  void write(Vertex v, const Target::Share& share);

 private:
  void write_vertex_values(Vertex v, const std::array<Vertex, 3>& corners, const Target::Share& share);
  std::uint32_t value_of(const CornerAttribute& attribute, const std::array<Halfedge, 3>& corners,
                         const Target::Share& share);

  Edit& edit_;
  const Mesh& before_;
  std::vector<CornerAttribute> attributes_;
};

}  // namespace ryosen::remesh
