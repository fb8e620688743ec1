// Closes holes by patches that continue the surface around them.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Spans every boundary loop (of so many edges at most, where a number is given) by triangles [Liepa03], refines them
// until their edges are as long as those around, and lets the new vertices settle such that the patch bends as little as
// it can (fair_patch.h). Where an edge of the surface stands in the way of every triangulation, a vertex in the middle
// is joined to all corners instead. Left open: loops that pass a point twice, that run along a cut edge, or pass a place
// that is not finite, three edges that a face is already on, and borders that lie on each other (weld their points),
// which only triangles without area could close. Patches take the face values of a face beside them.
// Cost: O(n^3) for loops of up to most_weighed_corners corners, O(n log n) beyond, and the new vertices.
AlgorithmResult fill_holes(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
