// Repair: cuts the surface apart at non-manifold points.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Each fan of faces at a non-manifold point becomes a point of its own at the same position; fans joined by a
// misoriented edge stay together where this leaves neither a non-manifold edge nor another misoriented one. So three
// faces at an edge are separated, two solids that touch along an edge or in a point become two, and no face or position
// changes. The faces at the lowest copy keep the number of the point. Cost: O(k log k) for the k faces at the
// non-manifold points, and O(n) to find them.
AlgorithmResult detach_nonmanifold(Edit& edit, const AlgorithmInput&, Progress& progress);

// The same for the non-manifold ones among the points `gently`; at those of `wholly` every fan becomes a point, whether
// the point is manifold or not. Where this cuts a misoriented edge and leaves a non-manifold point at its other end, that
// is detached too. Returns the number of new points.
std::size_t detach_points(Edit& edit, std::vector<Vertex> gently, std::vector<Vertex> wholly = {});

}  // namespace ryosen
