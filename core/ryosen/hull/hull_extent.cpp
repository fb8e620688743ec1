#include "ryosen/hull/hull_extent.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/affine_basis.h"
#include "ryosen/hull/antipodes.h"
#include "ryosen/hull/hull_measures.h"

namespace ryosen {

namespace {

using Index = std::uint32_t;
using hull::UnitPlaces;

// The farthest of the pairs that are offered.
class FarthestPair {
 public:
  FarthestPair(std::span<const glm::dvec3> points, const UnitPlaces& places) : points_(points), places_(places) {}

  // Exact; of equally far ones the lexicographically first stays.
  void offer(std::uint32_t p, std::uint32_t q) {
    const double length = glm::length(places_[p] - places_[q]);
    if (length < length_ * (1 - 1e-14)) return;
    const std::pair<std::uint32_t, std::uint32_t> pair = std::minmax(p, q);
    if (has_any_) {
      const int sign = compare_lengths({points_[p], points_[q]}, {points_[pair_.first], points_[pair_.second]});
      if (sign < 0 || (sign == 0 && pair >= pair_)) return;
    }
    has_any_ = true;
    pair_ = pair;
    length_ = length;
  }
  std::pair<std::uint32_t, std::uint32_t> pair() const { return pair_; }
  double length() const { return length_; }  // in units of the places

 private:
  std::span<const glm::dvec3> points_;
  const UnitPlaces& places_;
  std::pair<std::uint32_t, std::uint32_t> pair_{};
  double length_ = 0;
  bool has_any_ = false;
};

class Measuring {
 public:
  Measuring(std::span<const glm::dvec3> points, const ConvexHull& hull)
      : points_(points), hull_(hull), places_(points, hull.vertices), farthest_(points, places_) {}

  void measure_segment() { farthest_.offer(hull_.vertices[0], hull_.vertices[1]); }

  void measure_polygon() {
    const std::span<const Index> corner = hull_.facet(0);
    const std::size_t count = corner.size();
    const auto place = [&](std::size_t i) -> const glm::dvec3& { return points_[corner[i % count]]; };
    glm::dvec3 up(0.0);
    up[hull::largest_normal_axis(place(0), place(1), place(2)).axis] = 1;
    // Whether side j still goes away from side i.
    const auto turn = [&](std::size_t i, std::size_t j) {
      return determinant_sign({place(i), place(i + 1)}, {place(j), place(j + 1)}, {glm::dvec3(0.0), up});
    };
    std::size_t far = 1;
    for (std::size_t i = 0; i < count; ++i) {
      while (turn(i, far) > 0) ++far;
      const Index a = corner[i], b = corner[(i + 1) % count], c = corner[far % count];
      farthest_.offer(a, c);
      farthest_.offer(b, c);
      if (turn(i, far) == 0) {  // a side parallel to this one
        const Index d = corner[(far + 1) % count];
        farthest_.offer(a, d);
        farthest_.offer(b, d);
      }
      const glm::dvec3 side = places_[b] - places_[a];
      const double width = glm::length(glm::cross(side, places_[c] - places_[a])) / glm::length(side);
      if (width < width_) offer_width(width, {std::min(a, b), std::max(a, b)}, {c});
    }
  }

  bool measure_solid(Progress& progress) {
    guess_farthest();
    hull::Antipodes antipodes(points_, hull_, progress);
    if (progress.is_cancelled()) return false;
    measure_facets(antipodes);
    return measure_edges(antipodes, progress);
  }

  HullExtent extent() && {
    HullExtent extent;
    const auto [p, q] = farthest_.pair();
    extent.farthest = {p, q};
    extent.diameter = places_.full(farthest_.length(), 1);
    if (hull_.dimension < 2) return extent;
    extent.width = places_.full(width_, 1);
    extent.between = std::move(between_);
    return extent;
  }

 private:
  void offer_width(double width, std::vector<Index> one, std::vector<Index> other) {
    width_ = width;
    between_ = {std::move(one), std::move(other)};
  }

  // Far apart, so that most pairs need not be looked at; and how far each point may be from any other.
  void guess_farthest() {
    Index from = hull_.vertices[0];
    for (int turn = 0; turn < 4; ++turn) {
      Index to = from;
      double longest = -1;
      for (const Index p : hull_.vertices)
        if (const double length = glm::length(places_[p] - places_[from]); length > longest) {
          longest = length;
          to = p;
        }
      farthest_.offer(from, to);
      from = to;
    }
    const auto [p, q] = farthest_.pair();
    middle_ = places_[p] / 2.0 + places_[q] / 2.0;
    for (const Index i : hull_.vertices) radius_ = std::max(radius_, glm::length(places_[i] - middle_));
  }

  double reach_of(Index p) const { return glm::length(places_[p] - middle_) + radius_; }
  bool may_be_farther(Index p) const { return reach_of(p) > farthest_.length() * (1 - 1e-12); }

  glm::dvec3 unit_normal(Index facet) const {
    const std::span<const Index> corner = hull_.facet(facet);
    const glm::dvec3 normal = hull::normal_of(places_[corner[0]], places_[corner[1]], places_[corner[2]]);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0.0);
  }

  // Between the plane of a facet and a point; what is no number, since a normal is below the smallest doubles, counts
  // for nothing.
  double width_below(Index facet, Index p) const {
    const std::span<const Index> corner = hull_.facet(facet);
    const glm::dvec3 a = places_[corner[0]], b = places_[corner[1]], c = places_[corner[2]];
    const double length = glm::length(hull::normal_of(a, b, c));
    return length > 0 ? std::abs(hull::six_volumes_of(a, b, c, places_[p])) / length
                      : std::numeric_limits<double>::infinity();
  }

  void measure_facets(hull::Antipodes& antipodes) {
    for (Index f = 0; f < hull_.facet_count(); ++f) {
      const std::span<const Index> corner = hull_.facet(f);
      const Index lowest = antipodes.lowest()[f];
      normals_.push_back(unit_normal(f));
      const double width = width_below(f, lowest);
      widths_.push_back(width);
      if (width < width_) offer_width(width, {corner.begin(), corner.end()}, {lowest});
      if (std::none_of(corner.begin(), corner.end(), [&](Index p) { return may_be_farther(p); })) continue;
      for (const Index q : antipodes.all_lowest(f))
        for (const Index p : corner) farthest_.offer(p, q);
    }
  }

  bool measure_edges(hull::Antipodes& antipodes, Progress& progress) {
    const hull::HullLinks& links = antipodes.links();
    for (Index side = 0; side < links.side_count(); ++side) {
      if (side % 1024 == 0 && !progress.go_on(side, links.side_count())) return false;
      if (side > links.twin(side)) continue;
      if (!may_be_thinner(antipodes, side) && !may_be_farther(links.from(side)) && !may_be_farther(links.to(side)))
        continue;
      for (const Index other : antipodes.edges_opposite(side)) measure_opposite(links, side, other);
    }
    return true;
  }

  // Between the normals of its facets the width is at least that between the edge and a fixed point, which is least at
  // the ends.
  bool may_be_thinner(const hull::Antipodes& antipodes, Index side) const {
    const hull::HullLinks& links = antipodes.links();
    const Index f = links.facet(side), g = links.facet(links.twin(side));
    const glm::dvec3 a = places_[links.from(side)];
    const double with_first = std::min(widths_[f], glm::dot(normals_[g], a - places_[antipodes.lowest()[f]]));
    const double with_second = std::min(widths_[g], glm::dot(normals_[f], a - places_[antipodes.lowest()[g]]));
    return std::max(with_first, with_second) < width_;
  }

  void measure_opposite(const hull::HullLinks& links, Index side, Index other) {
    const Index a = links.from(side), b = links.to(side), c = links.from(other), d = links.to(other);
    for (const Index p : {a, b})
      for (const Index q : {c, d}) farthest_.offer(p, q);
    const glm::dvec3 normal = glm::cross(places_[b] - places_[a], places_[d] - places_[c]);
    const double length = glm::length(normal);
    if (!(length > 0)) return;  // parallel: the planes of the facets beside them are as near
    const double width = std::abs(glm::dot(normal / length, places_[a] - places_[c]));
    if (width < width_) offer_width(width, {std::min(a, b), std::max(a, b)}, {std::min(c, d), std::max(c, d)});
  }

  std::span<const glm::dvec3> points_;
  const ConvexHull& hull_;
  UnitPlaces places_;
  FarthestPair farthest_;
  double width_ = std::numeric_limits<double>::infinity();
  std::array<std::vector<Index>, 2> between_;
  glm::dvec3 middle_{0.0};
  double radius_ = 0;
  std::vector<glm::dvec3> normals_;  // by facet, of length 1
  std::vector<double> widths_;       // between its plane and the lowest point
};

// A hull whose points are numbered by its extreme ones, in the same order: of a small hull among very many points the
// tables by point stay small.
struct OwnNumbers {
  OwnNumbers(std::span<const glm::dvec3> points, const ConvexHull& given) : hull(given) {
    for (const Index i : given.vertices) places.push_back(points[i]);
    std::iota(hull.vertices.begin(), hull.vertices.end(), Index{0});
    for (Index& corner : hull.corners)
      corner = static_cast<Index>(std::lower_bound(given.vertices.begin(), given.vertices.end(), corner) -
                                  given.vertices.begin());
  }
  std::vector<glm::dvec3> places;
  ConvexHull hull;
};

std::string names_of(const std::vector<Index>& points) {
  constexpr std::size_t most = 8;
  std::string names;
  for (std::size_t i = 0; i < std::min(points.size(), most); ++i)
    names += (i > 0 ? " v" : "v") + std::to_string(points[i]);
  return points.size() > most ? names + " ..." : names;
}

}  // namespace

HullExtent hull_extent(std::span<const glm::dvec3> points, const ConvexHull& hull, Progress& progress) {
  if (hull.dimension < 1) return {};
  const OwnNumbers own(points, hull);
  Measuring measuring(own.places, own.hull);
  if (hull.dimension == 1) measuring.measure_segment();
  if (hull.dimension == 2) measuring.measure_polygon();
  if (hull.dimension == 3 && !measuring.measure_solid(progress)) return {};
  HullExtent extent = std::move(measuring).extent();
  for (std::vector<Index>* const numbers : {&extent.farthest, &extent.between[0], &extent.between[1]})
    for (Index& i : *numbers) i = hull.vertices[i];
  return extent;
}

HullExtent hull_extent(std::span<const glm::dvec3> points, const ConvexHull& hull) {
  Progress progress;
  return hull_extent(points, hull, progress);
}

HullExtent extremes(const HullExtent& one, const HullExtent& other) {
  HullExtent both = one;
  if (!other.farthest.empty() && (one.farthest.empty() || other.diameter > one.diameter)) {
    both.farthest = other.farthest;
    both.diameter = other.diameter;
  }
  if (!other.between[0].empty() && (one.between[0].empty() || other.width < one.width)) {
    both.between = other.between;
    both.width = other.width;
  }
  return both;
}

Text extent_sentence(const HullExtent& extent) {
  if (extent.farthest.empty()) return {};
  const std::string p = "v" + std::to_string(extent.farthest[0]), q = "v" + std::to_string(extent.farthest[1]),
                    diameter = hull::in_short(extent.diameter);
  Text text{"Farthest apart: " + p + " and " + q + ", " + diameter + ".",
            "最も遠い 2 点：" + p + " と " + q + "、距離 " + diameter + "。"};
  if (extent.between[0].empty()) return text;
  const std::string one = names_of(extent.between[0]), other = names_of(extent.between[1]),
                    width = hull::in_short(extent.width);
  return text + Text{" Smallest width: " + width + ", between " + one + " and " + other + ".",
                     "最小の幅：" + width + "（" + one + " と " + other + " の間）。"};
}

}  // namespace ryosen
