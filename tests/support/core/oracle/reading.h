// Reading a polygon list on points: which corners of faces are which copy of a point.
#pragma once

#include <vector>

#include "tests/support/core/oracle/polygons.h"

namespace ryosen::oracle {

// A polygon list in which every copy of a point is a vertex of its own, and the point of each copy. A point has the
// number of its first copy.
struct CopyList {
  PolygonList list;
  std::vector<int> point_of;  // one per number of a copy
};

// Fans of faces around a point, joined through the pairs that two faces run in opposite directions and no third, are
// the copies. The fan with the lowest face keeps the point's number; further fans get numbers from points.size() on,
// ordered by point, then by lowest face. The faces must be simple; a point without a face is its only copy.
//
// An outside loop of exactly two halves needs no step of its own: its two cut sides run between the same two copies in
// opposite directions, so in the list of copies they are one edge. The test counts such loops and checks this.
CopyList read_copies(const PolygonList& points);

// The list on points: each copy replaced by its point.
PolygonList points_of(const CopyList& copies);

// For each corner, numbered through, the first corner of its fan: what reading a list on points joins.
std::vector<int> fans_as_read(const PolygonList& points);
// For each corner the first corner with the same copy: what the list of copies says.
std::vector<int> fans_as_listed(const PolygonList& copies);

}  // namespace ryosen::oracle
