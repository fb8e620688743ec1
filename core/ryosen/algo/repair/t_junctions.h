// T-junctions: points that lie on a side of a face which has no other face.
#pragma once

#include <vector>

#include "ryosen/algo/repair/near_points.h"

namespace ryosen {

struct TJunction {
  Halfedge side;  // with a face and none beyond
  Vertex point;   // which lies on the side, between its ends
  double share;   // of the way along the side, 0 to 1
};

// The points at the ends of lone sides (lone_sides) that lie on other lone sides: exactly, or within the distance and
// farther than that from both ends. Of several points near each other on one side there is one. By side, those nearest
// to its end first. Sides of faces without area have none. Only sides count along which a side that ends at the point
// may run. The point and these sides are left out where there are far more of them than sides that end there, so that
// they lie on each other, or where hundreds of other sides pass there. `near` are the points that count as one. O(n log
// n), plus the places that lie between the sides of a slab around a side.
std::vector<TJunction> find_t_junctions(const Mesh& mesh, const NearPoints& near, double distance);

}  // namespace ryosen
