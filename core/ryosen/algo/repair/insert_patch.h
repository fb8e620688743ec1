// Puts a planned patch into the mesh.
#pragma once

#include "ryosen/algo/repair/hole_loop.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// The faces take the values (material, group) of a face at the loop, new vertices the mean of those around them. The
// boundary vertices may then need Sheets::make_manifold. Cost: the patch and the valences at the loop.
void insert_patch(Edit& edit, const HoleLoop& hole, const HolePatch& patch);

}  // namespace ryosen
