// Pairing where every two points are joined by one side or by one in each direction: nothing has to be cut.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/handle.h"
#include "core/indexed/indexed.h"
#include "core/mesh/column_memory.h"

namespace ryosen {

// An edge is filed under its smaller point; a side is "up" when it runs from the smaller to the larger one. Edges with
// an up side come first, by smaller point, then in the order of the faces (at a point with many, by larger point); then
// those with nothing but a down side. The even half of an edge is the up one.
struct RegularPairing {
  struct Point {
    std::uint32_t edge_end = 0;            // where its edges end and those of the next point begin
    std::uint32_t last_corner = no_index;  // the last corner that is on it
  };
  struct Sides {
    std::uint32_t larger;  // the larger point
    std::uint32_t up;      // the corner where the up side begins
    std::uint32_t down;    // where the down side begins; no_index: outside
  };
  UnwrittenVector<Point> points;
  UnwrittenVector<Sides> sides;          // per edge with an up side; a few more entries mean nothing
  UnwrittenVector<Halfedge> halfedge;    // per corner: the side that begins there
  std::vector<std::uint32_t> down_only;  // corners whose side is the only one of its edge, in order
  std::uint32_t up_edges = 0;

  std::uint32_t edges() const { return up_edges + static_cast<std::uint32_t>(down_only.size()); }
};

// None where some two points are joined otherwise. Two streams over the corners with a counting sort by smaller point
// between them, without a branch that depends on the data. The result is the same for any number of threads.
// O(corners) plus sorting at the few points of high valence.
std::optional<RegularPairing> pair_regular(const IndexedMesh& source, unsigned threads);

// The face list is nothing but triangles, none of them quarantined.
bool is_all_triangles(const IndexedMesh& source);

}  // namespace ryosen
