#include "ryosen/hull/unite_facets.h"

#include <algorithm>

#include "ryosen/base/handle.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/face_plane.h"

namespace ryosen::hull {

namespace {

using Index = std::uint32_t;

struct BoundaryEdge {
  Index from, to;
};

class Uniter {
 public:
  Uniter(std::span<const glm::dvec3> points, std::span<const HullTriangle> triangles)
      : points_(points), triangles_(triangles), is_done_(triangles.size()) {
    reach_ = reach_of(points);
  }

  FacetList unite() {
    for (Index t = 0; t < triangles_.size(); ++t)
      if (!is_done_[t]) add_facet(t);
    return std::move(facets_);
  }

 private:
  void add_facet(Index first) {
    const auto& c = triangles_[first].corners;
    plane_ = face_plane(points_[c[0]], points_[c[1]], points_[c[2]], reach_);
    group_.assign(1, first);
    boundary_.clear();
    is_done_[first] = true;
    for (std::size_t at = 0; at < group_.size(); ++at) {
      const HullTriangle triangle = triangles_[group_[at]];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index beside = triangle.beside[k];
        const Index from = triangle.corners[k], to = triangle.corners[(k + 1) % 3];
        if (!is_in_plane(c, beside, from, to)) {
          boundary_.push_back({from, to});
        } else if (!is_done_[beside]) {
          is_done_[beside] = true;
          group_.push_back(beside);
        }
      }
    }
    if (group_.size() == 1)
      add_polygon(c);
    else
      add_polygon(loop());
  }

  bool is_in_plane(const std::array<Index, 3>& c, Index triangle, Index from, Index to) const {
    const auto& other = triangles_[triangle].corners;
    const Index third = other[0] != from && other[0] != to   ? other[0]
                        : other[1] != from && other[1] != to ? other[1]
                                                             : other[2];
    const glm::dvec3& p = points_[third];
    return side(plane_, plane_.height(p), points_[c[0]], points_[c[1]], points_[c[2]], p) == 0;
  }

  // The edges of the boundary, which is one cycle, end to end.
  const std::vector<Index>& loop() {
    std::sort(boundary_.begin(), boundary_.end(),
              [](const BoundaryEdge& a, const BoundaryEdge& b) { return a.from < b.from; });
    loop_.clear();
    const BoundaryEdge* edge = boundary_.data();
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      loop_.push_back(edge->from);
      edge = &*std::lower_bound(boundary_.begin(), boundary_.end(), edge->to,
                                [](const BoundaryEdge& e, Index from) { return e.from < from; });
    }
    return loop_;
  }

  template <class Corners>
  void add_polygon(const Corners& corners) {
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Index before = corners[(i + count - 1) % count], after = corners[(i + 1) % count];
      if (count == 3 || !are_collinear(points_[before], points_[corners[i]], points_[after]))
        facets_.corners.push_back(corners[i]);
    }
    facets_.offsets.push_back(static_cast<Index>(facets_.corners.size()));
  }

  std::span<const glm::dvec3> points_;
  std::span<const HullTriangle> triangles_;
  std::vector<bool> is_done_;
  glm::dvec3 reach_{0.0};
  FacePlane plane_{};
  std::vector<Index> group_, loop_;
  std::vector<BoundaryEdge> boundary_;
  FacetList facets_;
};

}  // namespace

FacetList unite_facets(std::span<const glm::dvec3> points, std::span<const HullTriangle> triangles) {
  return Uniter(points, triangles).unite();
}

FacetList in_order(const FacetList& facets, std::span<const std::uint32_t> numbers) {
  struct Key {
    Index second, facet;
  };
  const auto lowest = [&](std::span<const Index> facet) {
    return std::min_element(facet.begin(), facet.end(), [&](Index a, Index b) { return numbers[a] < numbers[b]; });
  };
  Index end = 0;
  for (const Index corner : facets.corners) end = std::max(end, numbers[corner] + 1);
  std::vector<Index> begin(std::size_t{end} + 1);  // by first corner
  for (std::size_t f = 0; f < facets.count(); ++f) ++begin[numbers[*lowest(facets.facet(f))] + 1];
  for (Index i = 0; i < end; ++i) begin[i + 1] += begin[i];
  std::vector<Key> keys(facets.count());
  {
    std::vector<Index> place(begin.begin(), begin.end() - 1);
    for (std::size_t f = 0; f < facets.count(); ++f) {
      const std::span<const Index> facet = facets.facet(f);
      const auto first = lowest(facet);
      const Index second = numbers[first + 1 == facet.end() ? facet.front() : *(first + 1)];
      keys[place[numbers[*first]]++] = {second, static_cast<Index>(f)};
    }
  }
  FacetList ordered;
  ordered.corners.reserve(facets.corners.size());
  ordered.offsets.reserve(facets.offsets.size());
  for (Index i = 0; i < end; ++i)
    std::sort(keys.begin() + begin[i], keys.begin() + begin[i + 1],
              [](const Key& a, const Key& b) { return a.second < b.second; });
  for (const Key& key : keys) {
    const std::span<const Index> facet = facets.facet(key.facet);
    const auto first = lowest(facet);
    for (auto at = first; at != facet.end(); ++at) ordered.corners.push_back(numbers[*at]);
    for (auto at = facet.begin(); at != first; ++at) ordered.corners.push_back(numbers[*at]);
    ordered.offsets.push_back(static_cast<Index>(ordered.corners.size()));
  }
  return ordered;
}

}  // namespace ryosen::hull
