// Repairs that weld points at equal or nearby positions.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/algo/repair/near_points.h"

namespace ryosen {

// Welds where sides of faces lie on each other: the sides between the same two places that have no face beyond are
// paired (pair_at_places); both of a pair become one edge, and their ends become points. So solids of which each face
// has points of its own close, those that share walls, too. Where two sides, and no third one, run in one direction the
// faces of one part of the surface are turned round then, the smaller part, where that makes all agree. Nothing is done
// that would tear a surface with non-manifold edges (is_torn). A pair is left as a seam if one of its ends is
// non-manifold, or if a face would visit a point twice, an edge get a third face, or two faces the same points
// (point_merger.h): so no new findings but pockets (pockets.h), which close. Points that no such side joins stay apart,
// so that no bow-tie is made; isolated ones at a place of others are removed, but for those that something beside the
// mesh uses and that stay in the file for it. The lowest number stays, -0 = 0. `left` counts the places that still have
// several points. Cost: O(n log n), however many points are at one place.
AlgorithmResult weld_equal_points(Edit& edit, const AlgorithmInput&, Progress& progress);

// The same within a distance, and edges within it collapse first, where the operator's verdict allows it. Points join
// the first one in file order that is within the distance and has not itself joined another, and take its position, so
// no point moves by more than the distance. Nothing is done that would make a face flat. `crossings` counts the pairs
// of faces that meet afterwards and did not before. Cost: that of two searches for self-intersections.
AlgorithmResult weld_close_points(Edit& edit, const AlgorithmInput& input, Progress& progress);

// The common part of both: welds points that are near each other, edges between them apart. Returns the sides that were
// joined, by the numbers that their edges had. The only write of the edit.
std::vector<Edge> weld_near_points(Edit& edit, const Reach& reach, Progress& progress);

}  // namespace ryosen
