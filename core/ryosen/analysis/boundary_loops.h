// Boundary loops on points: boundary edges chained through the fan of faces at each vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/index_set.h"
#include "ryosen/base/message.h"

namespace ryosen {

// Loops sorted by their lowest edge; each as its halfedges without a face, in traversal order (past a misoriented edge
// they point against it).
struct BoundaryLoops {
  std::vector<Halfedge> halfedges;
  std::vector<std::uint32_t> offsets{0};  // loops + 1 entries
  bool has_open_chain = false;            // some boundary edges belong to no loop

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const Halfedge> operator[](std::size_t loop) const {
    return {halfedges.data() + offsets[loop], offsets[loop + 1] - offsets[loop]};
  }
};

// `boundary` holds the edges with one face on points (the set of ProblemKind::boundary_loop). A chain that ends at a
// non-manifold edge is not a loop: then the loops are no number of holes (no_loop_count). Cost: the boundary edges,
// plus the fans at points with copies.
BoundaryLoops find_boundary_loops(Neighbourhood& around, const IndexSet& boundary);

// Why a mesh with an open chain has no number of boundary loops.
inline const Text no_loop_count{"Some boundary edges end at an edge of three or more faces and close to no loop.",
                                "三つ以上の面が接する稜線で途切れ、輪にならない境界があります。"};

}  // namespace ryosen
