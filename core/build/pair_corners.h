// Pairing: which halfedge each corner of a polygon list becomes.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/handle.h"
#include "core/build/indexed.h"

namespace ryosen {

struct CornerPairing {
  std::vector<Halfedge> halfedge;  // of the side that begins at each corner
  std::uint32_t edges = 0;
  bool has_cuts = false;  // some point pair is non-manifold or misoriented, so its faces got edges of their own
};

// Joins two faces that run a pair of points in opposite directions when no third one does; any other face gets an edge
// of its own. Edges are numbered by their smaller point, then the larger one, so that one-rings lie close together; an
// even halfedge runs from the smaller to the larger point. Counting sort on the smaller point: O(corners).
CornerPairing pair_corners(const IndexedMesh& source);

}  // namespace ryosen
