// Refinement of a patch of triangles to the edge lengths of the surrounding surface.
#pragma once

#include "core/algo/repair/hole_loop.h"
#include "core/base/progress.h"

namespace ryosen {

// Alternately splits triangles whose centroid is far from their corners relative to the edge lengths there, and swaps
// edges towards a Delaunay triangulation [Liepa03]. The wanted length is that of the surroundings at the loop and grows
// with the distance from it, the more the longer the loop: about one new vertex per corner in long loops, and none beyond
// 70,000 corners. Sides of the loop stay, no triangle becomes degenerate, and no edge that exists is made again.
void refine(HolePatch& patch, const HoleLoop& loop, Progress& progress);

}  // namespace ryosen
