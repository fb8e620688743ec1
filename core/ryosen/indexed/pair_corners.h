// Pairing of face sides into edges: which halfedge each corner of a polygon list becomes.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/handle.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen {

// Counters of the comparisons of code that is measured: of none where its time is taken, of each where its work is.
struct NotCounted {
  static constexpr void count() {}
};

struct Counted {
  std::uint64_t comparisons = 0;
  void count() { ++comparisons; }
};

struct CornerPairing {
  UnwrittenVector<Halfedge> halfedge;  // per corner: of the side that starts there
  std::uint32_t edges = 0;
  bool has_cuts = false;  // some point pair is non-manifold or misoriented, so its faces got edges of their own
};

// Joins two faces that traverse a pair of points in opposite directions if no third face does; any other face gets an
// edge of its own. Edges are sorted by their smaller point, so that one-rings are close in memory (but see
// RegularPairing for boundary edges); an even halfedge goes from the smaller to the larger point. Counting sort on the
// smaller point: O(corners).
CornerPairing pair_corners(const IndexedMesh& source);

// The same pairing for any list, always with the edges sorted by smaller, then larger point.
CornerPairing pair_with_cuts(const IndexedMesh& source);
// The same, and how often two sides of a bucket were compared. For a regular list pair_corners() compares the sides of
// a bucket by fours instead of sorting them.
CornerPairing pair_counting(const IndexedMesh& source, Counted& counter);

}  // namespace ryosen
