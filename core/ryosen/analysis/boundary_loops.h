// Boundary loops on points: boundary edges chained through the fan of faces at each vertex, and their number, updated
// incrementally at the cost of what an edit touches.
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

// The number of boundary loops. Stores for both ends of every boundary edge where the boundary continues. An edit
// changes these links only at the points it touches; if the boundary leaves that part at the same ends, joined in the
// same pairs, the number of loops through it is unchanged and nothing else is visited.
class BoundaryLoopCount {
 public:
  BoundaryLoopCount() = default;

  // Counts from scratch. `boundary` is the set of ProblemKind::boundary_loop. Cost: the boundary edges.
  void search(Neighbourhood& around, const IndexSet& boundary);
  // After an edit: `edges` are all edges that are, or were, at the points where anything changed, and those whose
  // membership in `boundary` changed; ascending. Equivalent to search(). Cost: these edges and the one-rings of their
  // ends; if the edit joins or splits boundaries also the loops through them.
  void update(Neighbourhood& around, const IndexSet& boundary, std::span<const Edge> edges);

  std::uint32_t count() const { return count_; }
  // Whether some boundary edges belong to no loop: their chain ends at a non-manifold edge.
  bool has_open_chain() const { return stops_ > 0; }
  // Changes whenever the loops may consist of other edges.
  std::uint64_t revision() const { return revision_; }

 private:
  std::vector<std::uint32_t> links_;  // by end of an edge: where the boundary continues, if it does
  std::uint32_t count_ = 0;
  std::uint32_t stops_ = 0;  // ends that are linked to a stop
  std::uint64_t revision_ = 0;
};

}  // namespace ryosen
