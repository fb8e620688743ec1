// The sides of the facets of a convex hull, linked: from each to the one on the other side of its edge.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/hull/convex_hull.h"

namespace ryosen::hull {

// A side has the number of the place in ConvexHull::corners from which it runs to the next corner of its facet.
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

}  // namespace ryosen::hull
