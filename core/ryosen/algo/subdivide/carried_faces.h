// The attributes of the new faces of a subdivision.
#pragma once

#include <functional>

#include "ryosen/mesh/mesh.h"

namespace ryosen::subdivide {

// The new face at a corner of an old one, which it comes of. One of those that come of a face may keep its number.
using ChildAt = std::function<Face(Halfedge)>;

// Gives the new faces, whose links and places are there, the values of the faces that they come of: sums are divided by
// area.
void carry_faces(const Mesh& mesh, AttributeColumn& column, const MeshColumns& out, const ChildAt& child);

}  // namespace ryosen::subdivide
