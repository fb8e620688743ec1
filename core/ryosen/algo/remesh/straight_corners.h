// Taking out the corners of polygons that lie on straight edges.
#pragma once

#include <cstddef>

#include "ryosen/base/progress.h"
#include "ryosen/mesh/edit.h"

namespace ryosen::remesh {

struct StraightOptions {
  double angle_rad = 0;  // the parts of an edge are within this of its direction
  double distance = 0;   // and its corners within this of it; 0: exactly on it
};

// Takes out vertices with two edges that lie on the straight line between those that stay, in the faces of both sides,
// where unite_edge may and no face loses its area. A vertex with more edges stays, and so does one with copies. Of a
// loop that has only vertices with two edges the first place in the order of coordinates and the one farthest from it
// stay. Returns how many went. O(n log n).
std::size_t drop_straight_corners(Edit& edit, const StraightOptions& options, Progress& progress);

}  // namespace ryosen::remesh
