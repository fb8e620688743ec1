// Makes points at one place, or near each other, one point.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Points with equal coordinates (-0 = 0) become one, the lowest number stays; isolated ones among them go. Sides of two
// faces that come together become one edge where two faces run it in opposite directions. Where the welded point
// would be a bow-tie its fans of faces stay points of their own. A group is left as it is where a face or a wire ends at
// two of its points, where one of them is non-manifold already, and where it would end a non-manifold edge or two faces
// would come onto the same points: so what is sound stays sound. Cost: some rounds of O(n log n).
AlgorithmResult weld_equal_points(Edit& edit, const AlgorithmInput&, Progress& progress);

// The same for points no farther apart than the distance, whatever comes of it; asked for by name. Points join the first
// in file order that is near enough and has not joined another itself, and take its place, so nothing moves by more than
// the distance. Edges within a group collapse first; a group that still has two points of one face is left.
AlgorithmResult weld_close_points(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
