// Triangulation of a long loop in space by cutting ears.
#pragma once

#include "ryosen/algo/repair/hole_triangles.h"

namespace ryosen {

// Cuts corner after corner off the loop, first where the cut is short and folds the surface least. Neither flat
// triangles nor edges that exist are made. For loops that no projection shows as a simple polygon. O(n log n).
HoleTriangles cut_ears(const HoleLoop& loop, Progress& progress);

}  // namespace ryosen
