// Refinement of a patch of triangles to the edge lengths of the surrounding surface.
#pragma once

#include "ryosen/algo/repair/hole_loop.h"
#include "ryosen/base/progress.h"

namespace ryosen {

// Alternately splits triangles whose centroid is far from their corners relative to the edge lengths there, swaps edges
// towards a Delaunay triangulation [Liepa03], and moves new vertices along the patch towards the middle of their
// neighbours. The wanted length is that of the surroundings at the loop; with each unit of distance from it it grows by
// `most_growth`, or less in loops of fewer corners than 1000 times that: with 0.4 there is about one new vertex per
// corner in long loops. Sides of the loop stay, no triangle becomes degenerate, and no edge that exists is made again.
// To be called again when the places of new vertices have changed: further ones come where the patch has become coarse.
void refine(HolePatch& patch, const HoleLoop& loop, double most_growth, Progress& progress);

// Swaps edges alone: no vertex comes or moves.
void swap_edges(HolePatch& patch, const HoleLoop& loop, Progress& progress);

}  // namespace ryosen
