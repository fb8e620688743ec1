// Repairs that weld points at equal or nearby positions.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Points with equal coordinates (-0 = 0) are merged, the lowest number stays; isolated ones among them are removed.
// Coincident sides become one edge if exactly two faces traverse them in opposite directions. If the merged point would
// be a bow-tie its fans stay separate points. A group is skipped if a face or wire contains two of its points, if one
// of them is already non-manifold, or if merging would create a non-manifold edge or duplicate faces: so no new
// defects. Cost: a few rounds of O(n log n).
AlgorithmResult weld_equal_points(Edit& edit, const AlgorithmInput&, Progress& progress);

// The same within a distance, without these guarantees; run only on request. Points join the first one in file order
// that is within the distance and has not itself joined another, and take its position, so no point moves by more than
// the distance. Edges within a group are collapsed first; a group that still has two points of one face is skipped.
AlgorithmResult weld_close_points(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
