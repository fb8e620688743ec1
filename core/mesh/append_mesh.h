// Adds all elements of one mesh to another.
#pragma once

#include "core/mesh/edit.h"

namespace ryosen {

// The elements of `part` become components of their own, in their order behind those that are there. `part` has no dead
// elements, copies or rings; its attributes are left out, and the new elements have the fill of those of the mesh. Cost:
// the elements of `part`.
void append_mesh(Edit& edit, const Mesh& part);

}  // namespace ryosen
