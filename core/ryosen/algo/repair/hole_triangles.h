// Triangulations of a hole's boundary loop in space.
#pragma once

#include <vector>

#include "ryosen/algo/repair/find_holes.h"

namespace ryosen {

struct HoleTriangles {
  std::vector<CornerTriangle> triangles;
  WhyOpen cause = WhyOpen::without_area;  // or edge_exists: why there are none
};

// Larger loops are not weighed.
inline constexpr std::size_t most_weighed_corners = 300;

// The n - 2 non-degenerate triangles, oriented along the loop, that minimise the largest fold between neighbours (those
// beyond the loop included), then the area [Liepa03]; O(n^3), at most most_weighed_corners corners.
HoleTriangles weigh_triangles(const HoleLoop& loop, Progress& progress);
// Those of triangulate(); O(n log n).
HoleTriangles project_triangles(const HoleLoop& loop);

// Cuts corner after corner off the loop, first where the cut is short and folds the surface least. Neither flat
// triangles nor edges that exist are made. For loops that no projection shows as a simple polygon. O(n log n).
HoleTriangles cut_ears(const HoleLoop& loop, Progress& progress);

}  // namespace ryosen
