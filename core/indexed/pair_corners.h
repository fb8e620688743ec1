// Pairing: which halfedge each corner of a polygon list becomes.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/handle.h"
#include "core/indexed/indexed.h"
#include "core/mesh/column_memory.h"

namespace ryosen {

struct CornerPairing {
  UnwrittenVector<Halfedge> halfedge;  // of the side that begins at each corner
  std::uint32_t edges = 0;
  bool has_cuts = false;  // some point pair is non-manifold or misoriented, so its faces got edges of their own
};

// Joins two faces that run a pair of points in opposite directions when no third one does; any other face gets an edge
// of its own. Edges are numbered by their smaller point, so that one-rings lie close together (but see RegularPairing
// for those at the boundary); an even halfedge runs from the smaller to the larger point. Counting sort on the smaller
// point: O(corners).
CornerPairing pair_corners(const IndexedMesh& source);

// The same joints, whatever the list holds, with all edges in the order of their smaller, then their larger point.
CornerPairing pair_with_cuts(const IndexedMesh& source);

}  // namespace ryosen
