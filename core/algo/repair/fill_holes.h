// Repair: fills holes with patches that continue the surrounding surface smoothly.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Triangulates every boundary loop (of at most the given number of edges, if any) [Liepa03], refines the triangles to
// the edge lengths of the surroundings, and fairs the new vertices (fair_patch.h). If an existing edge conflicts with
// every triangulation, a fan around a vertex in the middle is used instead. Left open: loops that visit a point twice,
// contain a cut edge or a non-finite position, loops of three edges that already have a face on the same points, and
// coincident boundaries (weld their points), which only zero-area triangles could close. Patches take the face
// attributes of an adjacent face. Cost: O(n^3) for loops of up to most_weighed_corners corners, O(n log n) beyond, plus
// the new vertices.
AlgorithmResult fill_holes(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
