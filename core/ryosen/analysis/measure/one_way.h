// The distance of the points of one surface from another, in the scale of their trees.
#pragma once

#include "ryosen/analysis/measure/distance.h"
#include "ryosen/geometry/trees/triangle_tree.h"

namespace ryosen {

// Fills in what follows from the trees, neither of which is empty: all of `way` but the numbers of faces.
// `options.samples` is not 0. False where `progress` cancels. Progress is told on the calling thread.
bool measure_one_way(OneWayDistance& way, const TriangleTree& from, const TriangleTree& to,
                     const DistanceOptions& options, Progress& progress);

}  // namespace ryosen
