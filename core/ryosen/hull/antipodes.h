// What lies opposite on a solid hull: elements through which parallel planes run that have the whole hull between them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/base/progress.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/convex_hull.h"

namespace ryosen::hull {

// The sides of the facets of a convex hull, linked: from each to the one on the other side of its edge. A side has the
// number of the place in ConvexHull::corners from which it runs to the next corner of its facet.
class HullLinks {
 public:
  // Of a hull of dimension 3, which must outlive it. Cost: O(corners).
  explicit HullLinks(const ConvexHull& hull);

  std::uint32_t side_count() const { return static_cast<std::uint32_t>(next_.size()); }
  std::uint32_t from(std::uint32_t side) const { return hull_.corners[side]; }
  std::uint32_t to(std::uint32_t side) const { return hull_.corners[next_[side]]; }
  std::uint32_t next(std::uint32_t side) const { return next_[side]; }
  std::uint32_t twin(std::uint32_t side) const { return twin_[side]; }
  std::uint32_t facet(std::uint32_t side) const { return facet_[side]; }
  // One that runs from an extreme point.
  std::uint32_t side_from(std::uint32_t point) const { return side_from_[point]; }
  // The next one from the same point, clockwise seen from outside.
  std::uint32_t next_from(std::uint32_t side) const { return next_[twin_[side]]; }
  // A corner of the facet beyond the line of the side.
  std::uint32_t apex(std::uint32_t side) const { return hull_.corners[next_[next_[side]]]; }

 private:
  const ConvexHull& hull_;
  std::vector<std::uint32_t> next_, twin_, facet_;
  std::vector<std::uint32_t> side_from_;  // by number of the point
};

// What lies opposite to the facets and to the edges.
class Antipodes {
 public:
  // Of a hull of dimension 3. Points and hull must outlive it. By exact signs. Cost: O(facets) where corners have few
  // facets; a corner with k sides that is looked at for many facets costs k each time. A cancelled one is not to be
  // used.
  Antipodes(std::span<const glm::dvec3> points, const ConvexHull& hull, Progress& progress);

  const HullLinks& links() const { return links_; }
  // By facet an extreme point that lies farthest below its plane.
  const std::vector<std::uint32_t>& lowest() const { return lowest_; }
  // All extreme points that lie as far below the facet as that one; valid until the next call.
  const std::vector<std::uint32_t>& all_lowest(std::uint32_t facet);
  // Sides, one of each edge that is opposite to the edge of this side, where the lowest points of its two facets
  // differ; else none. Valid until the next call.
  const std::vector<std::uint32_t>& edges_opposite(std::uint32_t side);

 private:
  // Sign of the height of q above the plane through p that is parallel to the facet.
  int height_sign(std::uint32_t facet, std::uint32_t p, std::uint32_t q) const;
  std::uint32_t climb_down(std::uint32_t facet, std::uint32_t from) const;
  bool is_opposite(std::uint32_t side, std::uint32_t other) const;
  bool has_parallel_planes(std::uint32_t side, std::uint32_t other) const;
  Difference edge(std::uint32_t side) const { return {points_[links_.from(side)], points_[links_.to(side)]}; }
  void reach(std::uint32_t point);

  std::span<const glm::dvec3> points_;
  const ConvexHull& hull_;
  HullLinks links_;
  std::vector<std::uint32_t> lowest_;
  std::vector<std::uint32_t> reached_, edges_;  // points, and sides, by the search that goes on
  std::vector<std::uint32_t> mark_;             // by point the search that has reached it
  std::uint32_t search_ = 0;
};

}  // namespace ryosen::hull
