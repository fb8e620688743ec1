// Takes the surface apart where it is not a manifold.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// The fans of faces at a non-manifold point become points of their own, at the same place; those that a misoriented edge
// joins stay together while that leaves no non-manifold edge. So three faces on an edge come apart, two solids that touch
// along an edge or in a point become two, and no face and no place changes. The faces that hold the lowest copy keep the
// number of the point. Cost: the stars of the non-manifold points, and O(n) to find them.
AlgorithmResult detach_nonmanifold(Edit& edit, const AlgorithmInput&, Progress& progress);

// The same for these points alone, where they are non-manifold. Returns how many points that makes.
std::size_t detach_points(Edit& edit, std::vector<Vertex> points);

}  // namespace ryosen
