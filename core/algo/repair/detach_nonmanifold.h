// Repair: cuts the surface apart at non-manifold points.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Each fan of faces at a non-manifold point becomes a point of its own at the same position; fans joined by a
// misoriented edge stay together if that leaves no non-manifold edge. So three faces at an edge are separated, two
// solids that touch along an edge or in a point become two, and no face or position changes. The faces at the lowest
// copy keep the number of the point. Cost: the one-rings of the non-manifold points, and O(n) to find them.
AlgorithmResult detach_nonmanifold(Edit& edit, const AlgorithmInput&, Progress& progress);

// The same for the non-manifold ones among these points only. Returns the number of new points.
std::size_t detach_points(Edit& edit, std::vector<Vertex> points);

}  // namespace ryosen
