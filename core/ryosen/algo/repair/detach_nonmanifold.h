// Repair: cuts the surface apart at non-manifold points; what it asks and does at one point serves other repairs too.
#pragma once

#include "ryosen/algo/algorithm.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

// Faces are paired at edges of three or more (pair_faces.h), so that closed parts stay closed; then each fan of faces
// at a non-manifold point becomes a point of its own at the same position. Fans joined by a misoriented edge stay
// together where this leaves neither a non-manifold edge nor another misoriented one. So two solids that touch in a
// face, along an edge or in a point become two, a fin on a solid becomes a part, and no face or position changes.
// Boundary edges come only where a patch is set free or a misoriented edge is cut. The faces at the lowest copy keep
// the number of the point. Cost: O(n log n).
AlgorithmResult detach_nonmanifold(Edit& edit, const AlgorithmInput&, Progress& progress);

// The same for the non-manifold ones among the points `gently`, and for points connected with them by edges of three or
// more faces; at those of `wholly` every fan becomes a point, whether the point is manifold or not. Where this cuts a
// misoriented edge and leaves a non-manifold point at its other end, that is detached too. Returns the number of new
// points.
std::size_t detach_points(Edit& edit, std::vector<Vertex> gently, std::vector<Vertex> wholly = {});

// Whether the point is non-manifold, as the table of problems has it.
bool is_nonmanifold(Neighbourhood& around, Vertex point);

// Gives each fan at a vertex of a point a vertex of its own, as reading does.
void separate_fans_at(Sheets& sheets, Vertex point);

}  // namespace ryosen
