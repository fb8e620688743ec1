// Fairing of a patch so that it continues the surrounding surface smoothly.
#pragma once

#include "ryosen/algo/repair/hole_loop.h"
#include "ryosen/base/progress.h"

namespace ryosen {

// Moves of new vertices towards the least bending.
enum class FairMove { all_the_way, along_normals };

// Moves the new vertices to minimise the thin-plate energy, with tangent continuity at the loop: the sum over the
// vertices, the loop's included, of area times squared mean curvature normal, with cotangent weights: the bi-Laplacian
// of the places is zero [Botsch04]. The weights are those of the places before, so that it is to be called again. Moves
// along normals alone keep an even patch even. Conjugate gradients, at most 1000 steps, fewer in large patches. Nothing
// moves where the patch and the faces around it lie in a plane.
void fair(HolePatch& patch, const HoleLoop& loop, FairMove move, Progress& progress);

// Whether all corners and the vertices around them lie in a plane, but for rounding.
bool is_flat(const HoleLoop& loop);

}  // namespace ryosen
