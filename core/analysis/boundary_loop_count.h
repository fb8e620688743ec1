// How many boundary loops there are on points, kept current through edits at the cost of what they touch.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/analysis/index_set.h"
#include "core/analysis/neighbourhood.h"

namespace ryosen {

// Remembers for both ends of every boundary edge where the boundary goes on. An edit changes that at the points it
// touches only; as long as the boundary comes out of there at the same ends and they are joined there as before, as
// many loops pass through as before, and nothing else is looked at.
class BoundaryLoopCount {
 public:
  BoundaryLoopCount() = default;

  // Searches anew. `boundary` is the set of ProblemKind::boundary_loop. Cost: the boundary edges.
  void search(Neighbourhood& around, const IndexSet& boundary);
  // After an edit: `edges` holds all that are, or were, at the points where anything changed, and those whose
  // membership in `boundary` changed; ascending. The result is that of search(). Cost: these edges and the stars of
  // their ends; where the edit joins or parts boundaries also the loops that pass through.
  void update(Neighbourhood& around, const IndexSet& boundary, std::span<const Edge> edges);

  std::uint32_t count() const { return count_; }
  // Another one whenever the loops may consist of other edges.
  std::uint64_t revision() const { return revision_; }

 private:
  // One end of an edge: 2 * edge, plus 1 for the end of its first halfedge.
  using End = std::uint32_t;
  static constexpr End stop = no_index;  // at a non-manifold edge
  static constexpr End none = no_index - 1;
  using Links = std::unordered_map<End, End>;
  // Ends at which the boundary leaves a part, and where each is joined through the part: another one, or a stop.
  using Joints = std::unordered_map<End, End>;
  struct Part {
    Joints joints;
    std::uint32_t loops = 0;  // within the part
  };

  template <class Put>
  static void put_links(Neighbourhood& around, Edge e, Put put);
  std::uint32_t count_loops(const IndexSet& boundary) const;
  Links links_at(std::span<const Edge> edges) const;
  static Part part_of(const Links& links);
  // The joints through everything outside of the part whose links are given.
  Joints joints_outside(const Part& part, const Links& inside) const;

  std::vector<End> links_;  // by end: where the boundary goes on, or stops, or there is none
  std::uint32_t count_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace ryosen
