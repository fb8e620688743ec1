// The number of boundary loops on points, updated incrementally at the cost of what an edit touches.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/index_set.h"

namespace ryosen {

// Stores for both ends of every boundary edge where the boundary continues. An edit changes these links only at the
// points it touches; if the boundary leaves that part at the same ends, joined in the same pairs, the number of loops
// through it is unchanged and nothing else is visited.
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
  // One end of an edge: 2 * edge, plus 1 for the end of its first halfedge.
  using End = std::uint32_t;
  static constexpr End stop = no_index;  // at a non-manifold edge
  static constexpr End none = no_index - 1;
  using Links = std::unordered_map<End, End>;
  // Ends at which the boundary leaves a part, and what each is joined to within the part: another end, or a stop.
  using Joints = std::unordered_map<End, End>;
  struct Part {
    Joints joints;
    std::uint32_t loops = 0;  // within the part
  };

  template <class Put>
  static void put_links(Neighbourhood& around, Edge e, Put put);
  std::uint32_t count_loops(const IndexSet& boundary) const;
  Links links_at(std::span<const Edge> edges) const;
  static std::uint32_t stops_in(const Links& links);
  static Part part_of(const Links& links);
  // The joints through the complement of the part with the links `inside`.
  Joints joints_outside(const Part& part, const Links& inside) const;

  std::vector<End> links_;  // by end: where the boundary continues, or stop, or none
  std::uint32_t count_ = 0;
  std::uint32_t stops_ = 0;  // ends that are linked to a stop
  std::uint64_t revision_ = 0;
};

}  // namespace ryosen
