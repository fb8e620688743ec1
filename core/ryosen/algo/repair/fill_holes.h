// Repair: fills holes with patches, flat ones in the plane of the rim or fair ones that continue the surface.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Closes every boundary loop (of at most the given number of edges, if any) for which there is a sound patch.
//
// shape: `flat` adds vertices on the triangles between the corners of the rim alone; `fair` minimises bending, tangent
// to the faces at the rim (plan_patch.h); `auto` is flat where the rim lies in a plane but for rounding (rims.h),
// and then new vertices lie in it too, else fair. The text says which was made.
//
// Several patches are tried: the triangulation of least folds [Liepa03] and the projected one (hole_triangles.h), each
// refined (refine_patch.h) and as it is, then a fan around a vertex in the middle. The first is taken that has no
// degenerate triangle, makes no edge that exists, and crosses neither the surface nor itself nor another patch
// (patch_crossings.h). Equal rims get equal patches (rims.h). Other loops stay open, the result tells why and
// names what was crossed; with `crossing` `allow` such loops are filled at last, and the result counts the pairs of
// faces that meet. Open stay loops that visit a point twice, contain a cut edge or a non-finite position, and those of
// three edges that already have a face on the same points.
//
// Faces without area at a rim go first where the surface stays as it is (remove_degenerate.h). Done again it changes
// nothing. Where all positions are floats the new ones are too, so that a file of floats holds them. Patches take the
// face attributes of an adjacent face. Cost: O(n^3) for loops of up to most_weighed_corners corners, O(n log n) beyond,
// plus the new vertices and the pairs of overlapping boxes; a pass over the mesh for each way tried.
AlgorithmResult fill_holes(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
