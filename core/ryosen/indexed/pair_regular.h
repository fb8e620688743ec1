// Fast pairing for regular lists: every pair of points has at most one side in each direction, so nothing is cut.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/handle.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen {

// Edges are bucketed by smaller point; a side is "up" if it goes from the smaller to the larger point. Edges with an up
// side come first, by smaller point, then in face order (in large buckets by larger point); then those with only a down
// side. The even half of an edge is the up one.
struct RegularPairing {
  struct Point {
    std::uint32_t edge_end = 0;            // end of its edges, start of the next point's
    std::uint32_t last_corner = no_index;  // the last corner at it
  };
  struct Sides {
    std::uint32_t larger;  // the larger point
    std::uint32_t up;      // the corner where the up side starts
    std::uint32_t down;    // where the down side starts; no_index: boundary
  };
  UnwrittenVector<Point> points;
  UnwrittenVector<Sides> sides;          // per edge with an up side; a few dummy entries follow
  UnwrittenVector<Halfedge> halfedge;    // per corner: of the side that starts there
  std::vector<std::uint32_t> down_only;  // corners whose side is the only one of its edge, in order
  std::uint32_t up_edges = 0;

  std::uint32_t edges() const { return up_edges + static_cast<std::uint32_t>(down_only.size()); }
};

// Calls visit(corner, point, next point) for every side of the faces begin .. end-1.
template <class Visit>
void for_each_side(const IndexedMesh& source, std::uint32_t begin, std::uint32_t end, Visit visit) {
  const std::uint32_t* corners = source.corners.data();
  for (std::uint32_t f = begin; f < end; ++f) {
    const std::uint32_t first = source.face_offsets[f], last = source.face_offsets[f + 1];
    for (std::uint32_t c = first; c < last; ++c) visit(c, corners[c], corners[c + 1 < last ? c + 1 : first]);
  }
}

// None if the list is not regular. Two passes over the corners with a counting sort by smaller point between them,
// nearly free of data-dependent branches. The result does not depend on the number of threads. O(corners) plus sorting
// at the few points of high valence.
std::optional<RegularPairing> pair_regular(const IndexedMesh& source, unsigned threads);

// Whether all faces are triangles and none is quarantined.
bool is_all_triangles(const IndexedMesh& source);

}  // namespace ryosen
