#include "ryosen/hull/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "ryosen/base/parallel.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/place_keys.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/affine_basis.h"
#include "ryosen/hull/distinct_points.h"
#include "ryosen/hull/solid_hull.h"
#include "ryosen/hull/unite_facets.h"

namespace ryosen::hull {

namespace {

using Index = std::uint32_t;

struct OuterPoints {
  std::vector<std::uint32_t> numbers;  // ascending
  std::size_t finite = 0;              // how many of all points are
};

// Directions by the side of a cube that they leave it through, and a grid of cells there. A direction has the depth 1
// along the axis of its side.
constexpr int cells = 32;             // along each edge of the cube
constexpr std::size_t sides = 6;      // -x +x -y +y -z +z
constexpr double near_border = 1e-6;  // in cells: nearer to the border of a cell than this a direction belongs to none

struct SampleHull {
  std::vector<glm::dvec3> points;
  std::vector<HullTriangle> triangles;
  glm::dvec3 inside;
};

// Spread evenly over the numbers, by steps that have no common period with the usual orders of points.
std::vector<Index> sample_numbers(std::span<const glm::dvec3> points, std::size_t count) {
  std::vector<Index> numbers;
  std::uint64_t state = 0x9e3779b97f4a7c15u;
  const double stride = static_cast<double>(points.size()) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double within = static_cast<double>(state >> 40u) / 16777216.0;
    const auto number = static_cast<std::size_t>((static_cast<double>(i) + within) * stride);
    if (number < points.size() && is_finite(points[number])) numbers.push_back(static_cast<Index>(number));
  }
  return numbers;
}

std::optional<SampleHull> sample_hull(std::span<const glm::dvec3> points) {
  const std::size_t count = std::clamp<std::size_t>(points.size() / 32, 2000, 20000);
  DistinctPoints sample = distinct_points(points, sample_numbers(points, count));
  const AffineBasis basis = affine_basis(sample.places);
  if (basis.dimension < 3) return std::nullopt;
  Progress progress;
  SampleHull hull{std::move(sample.places), {}, glm::dvec3(0.0)};
  hull.triangles = solid_hull(hull.points, basis.points, progress);
  if (hull.triangles.size() > count / 2) return std::nullopt;  // too many are extreme
  for (const HullTriangle& t : hull.triangles)
    for (const Index i : t.corners) hull.inside += hull.points[i] / (3.0 * static_cast<double>(hull.triangles.size()));
  for (const HullTriangle& t : hull.triangles) {
    const auto& c = t.corners;
    if (orient3d(hull.points[c[0]], hull.points[c[1]], hull.points[c[2]], hull.inside) >= 0) return std::nullopt;
  }
  return hull;
}

glm::dvec3 direction_of(std::size_t side, double s, double t) {
  glm::dvec3 direction;
  const int axis = static_cast<int>(side / 2);
  direction[axis] = side % 2 ? 1 : -1;
  direction[(axis + 1) % 3] = s;
  direction[(axis + 2) % 3] = t;
  return direction;
}

class InnerStar {
 public:
  // `largest`: of all coordinates. Less deep than 2^-20 of it doubles may be too coarse to tell directions apart, by
  // near_border; so nothing is said there.
  InnerStar(const SampleHull& hull, double largest)
      : hull_(hull), inside_(hull.inside), least_depth_(std::max(1e-90, largest * 0x1p-20)) {
    for (const HullTriangle& t : hull.triangles) {
      const glm::dvec3& a = hull.points[t.corners[0]];
      const glm::dvec3 normal = glm::cross(hull.points[t.corners[1]] - a, hull.points[t.corners[2]] - a);
      steepness_.push_back(normal / glm::dot(normal, a - inside_));
    }
    constexpr std::size_t line = cells + 1;
    std::array<double, line * line> at_node;
    Index triangle = 0;
    depths_.resize(sides * cells * cells);
    for (std::size_t side = 0; side < sides; ++side) {
      for (std::size_t i = 0; i < line; ++i)
        for (std::size_t k = 0; k < line; ++k) {
          const std::size_t j = i % 2 ? line - 1 - k : k;  // to and fro, so that the next one is near
          const auto at = [](std::size_t n) { return 2.0 * static_cast<double>(n) / cells - 1; };
          at_node[i * line + j] = depth_towards(direction_of(side, at(i), at(j)), triangle);
        }
      for (std::size_t i = 0; i < cells; ++i)
        for (std::size_t j = 0; j < cells; ++j) {
          const double depth = std::min({at_node[i * line + j], at_node[i * line + j + 1], at_node[(i + 1) * line + j],
                                         at_node[(i + 1) * line + j + 1]});
          depths_[(side * cells + i) * cells + j] = depth * (1 - 1e-6);
        }
    }
  }

  // Of a finite place.
  bool holds(const glm::dvec3& p) const {
    const glm::dvec3 d = p - inside_;
    const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    const double depth = axis == 0 ? x : axis == 1 ? y : z;
    if (depth < least_depth_) return false;
    const double scale = cells / 2.0 / depth;
    const double s = (axis == 0 ? d.y : axis == 1 ? d.z : d.x) * scale + cells / 2.0;
    const double t = (axis == 0 ? d.z : axis == 1 ? d.x : d.y) * scale + cells / 2.0;
    const int i = static_cast<int>(s), j = static_cast<int>(t);
    const double u = s - i, v = t - j;
    if (!(std::min(u, v) > near_border && std::max(u, v) < 1 - near_border)) return false;
    const int side = 2 * axis + ((axis == 0 ? d.x : axis == 1 ? d.y : d.z) > 0 ? 1 : 0);
    const int cell = (side * cells + i) * cells + j;
    return depth < depths_[static_cast<std::size_t>(cell)];
  }

 private:
  // How far in this direction a place is that lies within the tetrahedron of the point inside and a triangle, so within
  // the hull; 0 where none is found. The triangles of a convex body are climbed from the last one to the steepest.
  double depth_towards(const glm::dvec3& direction, Index& triangle) const {
    double best = glm::dot(steepness_[triangle], direction);
    for (bool climbs = true; climbs;) {
      climbs = false;
      for (const Index beside : hull_.triangles[triangle].beside)
        if (const double steepness = glm::dot(steepness_[beside], direction); steepness > best) {
          best = steepness;
          triangle = beside;
          climbs = true;
          break;
        }
    }
    const double depth = (1 - 1e-7) / best;
    if (!(best > 0) || !(depth >= least_depth_)) return 0;
    const glm::dvec3 place = inside_ + depth * direction;
    if (is_within(triangle, place)) return depth;
    for (const Index beside : hull_.triangles[triangle].beside)
      if (is_within(beside, place)) return depth;
    return 0;
  }

  bool is_within(Index triangle, const glm::dvec3& p) const {
    const auto& c = hull_.triangles[triangle].corners;
    const glm::dvec3 &a = hull_.points[c[0]], &b = hull_.points[c[1]], &d = hull_.points[c[2]];
    return orient3d(a, b, d, p) <= 0 && orient3d(inside_, b, a, p) <= 0 && orient3d(inside_, d, b, p) <= 0 &&
           orient3d(inside_, a, d, p) <= 0;
  }

  const SampleHull& hull_;
  glm::dvec3 inside_;
  std::vector<glm::dvec3> steepness_;  // of each triangle: 1 over the depth of its plane in a direction is the product
  std::vector<double> depths_;         // by cell: what is less deep is inside
  double least_depth_;
};

template <class IsKept>
OuterPoints kept_points(std::span<const glm::dvec3> points, const IsKept& is_kept) {
  const unsigned parts = threads_for(points.size());
  std::vector<OuterPoints> kept(parts);
  for_each_part(static_cast<Index>(points.size()), parts, [&](unsigned part, Index begin, Index end) {
    OuterPoints of_part;
    for (Index i = begin; i < end; ++i) {
      if (!is_finite(points[i])) continue;
      ++of_part.finite;
      if (is_kept(points[i])) of_part.numbers.push_back(i);
    }
    kept[part] = std::move(of_part);
  });
  for (unsigned part = 1; part < parts; ++part) {
    kept[0].numbers.insert(kept[0].numbers.end(), kept[part].numbers.begin(), kept[part].numbers.end());
    kept[0].finite += kept[part].finite;
  }
  return std::move(kept[0]);
}

double largest_coordinate(std::span<const glm::dvec3> points) {
  const unsigned parts = threads_for(points.size());
  std::vector<double> largest(parts, 0.0);
  for_each_part(static_cast<Index>(points.size()), parts, [&](unsigned part, Index begin, Index end) {
    double of_part = 0;
    for (Index i = begin; i < end; ++i)
      if (is_finite(points[i]))
        of_part = std::max({of_part, std::abs(points[i].x), std::abs(points[i].y), std::abs(points[i].z)});
    largest[part] = of_part;
  });
  return *std::max_element(largest.begin(), largest.end());
}

// The finite points that may be extreme or equal to an extreme one: a few percent of points that fill a body, all where
// most are extreme. From the hull of a sample and a point inside it, a grid of
// directions gets places that are certainly within the hull, by exact signs; what lies well below these in its
// direction goes. The same points for any number of threads. Cost: O(n), some nanoseconds a point.
OuterPoints outer_points(std::span<const glm::dvec3> points) {
  constexpr std::size_t worth_it = 20000;
  const double largest = points.size() < worth_it ? 0.0 : largest_coordinate(points);
  if (largest > 1e-60 && largest < 1e90)
    if (const std::optional<SampleHull> hull = sample_hull(points)) {
      const InnerStar star(*hull, largest);
      return kept_points(points, [&](const glm::dvec3& p) { return !star.holds(p); });
    }
  return kept_points(points, [](const glm::dvec3&) { return true; });
}

// Of distinct points that are not all collinear: the extreme ones counter-clockwise, by the chains of [Andrew79].
// Exact. Cost: O(n log n).
std::vector<std::uint32_t> planar_hull(std::span<const glm::dvec2> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const glm::dvec2 &p = points[i], &q = points[j];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  std::vector<std::uint32_t> chain;
  const auto extend = [&](std::size_t first, std::uint32_t next) {
    while (chain.size() >= first + 2 &&
           orient2d(points[chain[chain.size() - 2]], points[chain.back()], points[next]) <= 0)
      chain.pop_back();
    chain.push_back(next);
  };
  for (const std::uint32_t i : order) extend(0, i);
  const std::size_t upper = chain.size() - 1;
  for (std::size_t i = order.size() - 1; i-- > 0;) extend(upper, order[i]);
  chain.pop_back();  // the first one again
  return chain;
}

// The ends of a segment.
std::vector<std::uint32_t> ends(const DistinctPoints& points) {
  const auto [low, high] = std::minmax_element(points.places.begin(), points.places.end(), is_before);
  return {points.numbers[static_cast<std::size_t>(low - points.places.begin())],
          points.numbers[static_cast<std::size_t>(high - points.places.begin())]};
}

FacetList polygon(const DistinctPoints& points, const AffineBasis& basis) {
  const SignedAxis up = largest_normal_axis(points.places[basis.points[0]], points.places[basis.points[1]],
                                            points.places[basis.points[2]]);
  std::vector<glm::dvec2> projected;
  projected.reserve(points.places.size());
  for (const glm::dvec3& p : points.places) projected.push_back(seen_along(p, up.axis));
  FacetList facets;
  facets.corners = planar_hull(projected);
  facets.offsets.push_back(static_cast<std::uint32_t>(facets.corners.size()));
  return facets;
}

}  // namespace

}  // namespace ryosen::hull

namespace ryosen {

ConvexHull convex_hull(std::span<const glm::dvec3> points, Progress& progress) {
  using namespace hull;
  ConvexHull result;
  const OuterPoints outer = outer_points(points);
  const DistinctPoints distinct = distinct_points(points, outer.numbers);
  const AffineBasis basis = affine_basis(distinct.places);
  FacetList facets;
  if (basis.dimension == 3) {
    const std::vector<HullTriangle> triangles = solid_hull(distinct.places, basis.points, progress);
    if (triangles.empty()) return result;
    facets = unite_facets(distinct.places, triangles);
  } else if (basis.dimension == 2) {
    facets = polygon(distinct, basis);
  } else if (basis.dimension == 1) {
    result.vertices = ends(distinct);
  } else if (basis.dimension == 0) {
    result.vertices = {distinct.numbers[0]};
  }
  result.dimension = basis.dimension;
  result.used = outer.finite;
  facets = in_order(facets, distinct.numbers);
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
