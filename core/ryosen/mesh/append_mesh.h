// Adds all elements of one mesh to another.
#pragma once

#include "ryosen/mesh/edit.h"

namespace ryosen {

enum class AppendedAttributes {
  none,        // the new elements have the fill of those of the mesh
  values,      // columns of the same name and type come along, but for those that refer to pools or tables of names
  same_pools,  // columns of the same name and size come along: the pools of both meshes are the same
};

// The elements of `part` become components of their own, in their order behind those that are there, with copies and
// rings. `part` has no dead elements. Cost: the elements of `part`, and a pass over the vertices for the first copies.
void append_mesh(Edit& edit, const Mesh& part, AppendedAttributes attributes = AppendedAttributes::none);

}  // namespace ryosen
