#include "ryosen/hull/convex_hull.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/affine_basis.h"
#include "ryosen/hull/distinct_points.h"
#include "ryosen/hull/inner_star.h"
#include "ryosen/hull/planar_hull.h"
#include "ryosen/hull/unite_facets.h"

namespace ryosen {

namespace {

using hull::AffineBasis;
using hull::DistinctPoints;

// The ends of a segment.
std::vector<std::uint32_t> ends(const DistinctPoints& points) {
  const auto [low, high] = std::minmax_element(points.places.begin(), points.places.end(), hull::is_before);
  return {points.numbers[static_cast<std::size_t>(low - points.places.begin())],
          points.numbers[static_cast<std::size_t>(high - points.places.begin())]};
}

hull::FacetList polygon(const DistinctPoints& points, const AffineBasis& basis) {
  const hull::SignedAxis up = hull::largest_normal_axis(points.places[basis.points[0]], points.places[basis.points[1]],
                                                        points.places[basis.points[2]]);
  std::vector<glm::dvec2> projected;
  projected.reserve(points.places.size());
  for (const glm::dvec3& p : points.places) projected.push_back(seen_along(p, up.axis));
  hull::FacetList facets;
  facets.corners = hull::planar_hull(projected);
  facets.offsets.push_back(static_cast<std::uint32_t>(facets.corners.size()));
  return facets;
}

}  // namespace

ConvexHull convex_hull(std::span<const glm::dvec3> points, Progress& progress) {
  ConvexHull result;
  const hull::OuterPoints outer = hull::outer_points(points);
  const DistinctPoints distinct = hull::distinct_points(points, outer.numbers);
  const AffineBasis basis = hull::affine_basis(distinct.places);
  hull::FacetList facets;
  if (basis.dimension == 3) {
    const std::vector<hull::HullTriangle> triangles = hull::solid_hull(distinct.places, basis.points, progress);
    if (triangles.empty()) return result;
    facets = hull::unite_facets(distinct.places, triangles);
  } else if (basis.dimension == 2) {
    facets = polygon(distinct, basis);
  } else if (basis.dimension == 1) {
    result.vertices = ends(distinct);
  } else if (basis.dimension == 0) {
    result.vertices = {distinct.numbers[0]};
  }
  result.dimension = basis.dimension;
  result.used = outer.finite;
  facets = hull::in_order(facets, distinct.numbers);
  if (facets.count() > 0) result.vertices = facets.corners;
  sort_unique(result.vertices);
  result.corners = std::move(facets.corners);
  result.facet_offsets = std::move(facets.offsets);
  return result;
}

ConvexHull convex_hull(std::span<const glm::dvec3> points) {
  Progress progress;
  return convex_hull(points, progress);
}

}  // namespace ryosen
