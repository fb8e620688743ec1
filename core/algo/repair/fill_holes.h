// Repair: fills holes with patches that continue the surrounding surface smoothly.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Closes every boundary loop (of at most the given number of edges, if any) for which there is a sound patch. Several
// are tried: the triangulation of least folds [Liepa03] and the projected one (hole_triangles.h), each refined and
// faired (refine_patch.h, fair_patch.h), only refined, and as it is; then a fan around a vertex in the middle. The first
// is taken that has no degenerate triangle, makes no edge that exists, and crosses neither the surface nor itself
// (patch_crossings.h). Other loops stay open, the result tells why; so do loops that visit a point twice, contain a cut
// edge or a non-finite position, and those of three edges that already have a face on the same points. Done again it
// changes nothing. Where all positions are floats the new ones are too, so that a file of floats holds them. Patches take
// the face attributes of an adjacent face. Cost: O(n^3) for loops of up to most_weighed_corners corners, O(n log n)
// beyond, plus the new vertices and the pairs of overlapping boxes; a pass over the mesh for each way tried.
AlgorithmResult fill_holes(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
