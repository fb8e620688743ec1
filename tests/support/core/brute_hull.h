// The convex hull of a few points by trying every plane: an oracle that shares no code with the library, for any kind
// of exact integer.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

namespace ryosen::test {

struct BruteHull {
  int dimension = -1;
  std::vector<std::uint32_t> vertices;          // ascending
  std::set<std::vector<std::uint32_t>> facets;  // each from its lowest number, counter-clockwise seen from outside

  friend bool operator==(const BruteHull&, const BruteHull&) = default;
};

// Integer holds products of two coordinates and their sums, Wide those of four.
template <class Integer, class Wide>
class BruteForce {
 public:
  using Point = std::array<Integer, 3>;

  explicit BruteForce(std::span<const Point> points) : points_(points) {
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (std::none_of(first_.begin(), first_.end(), [&](std::uint32_t j) { return points[j] == points[i]; }))
        first_.push_back(i);
  }

  BruteHull hull() {
    try_planes();
    if (first_.empty()) return hull_;
    hull_.dimension = std::max(hull_.dimension, first_.size() > 1 ? 1 : 0);
    if (hull_.dimension < 2) add_ends();
    std::sort(hull_.vertices.begin(), hull_.vertices.end());
    hull_.vertices.erase(std::unique(hull_.vertices.begin(), hull_.vertices.end()), hull_.vertices.end());
    return hull_;
  }

 private:
  static Point minus(const Point& p, const Point& q) {
    return {Integer(p[0] - q[0]), Integer(p[1] - q[1]), Integer(p[2] - q[2])};
  }
  static Point cross(const Point& p, const Point& q) {
    return {Integer(p[1] * q[2] - p[2] * q[1]), Integer(p[2] * q[0] - p[0] * q[2]), Integer(p[0] * q[1] - p[1] * q[0])};
  }
  static Wide dot(const Point& p, const Point& q) {
    return Wide(p[0]) * Wide(q[0]) + Wide(p[1]) * Wide(q[1]) + Wide(p[2]) * Wide(q[2]);
  }

  void try_planes() {
    for (const std::uint32_t a : first_)
      for (const std::uint32_t b : first_)
        for (const std::uint32_t c : first_)
          if (a < b && b < c) try_plane(a, cross(minus(points_[b], points_[a]), minus(points_[c], points_[a])));
  }

  void try_plane(std::uint32_t a, Point normal) {
    if (normal == Point{}) return;
    bool has_above = false, has_below = false;
    std::vector<std::uint32_t> on;
    for (const std::uint32_t i : first_) {
      const Wide height = dot(normal, minus(points_[i], points_[a]));
      has_above = has_above || height > 0;
      has_below = has_below || height < 0;
      if (height == 0) on.push_back(i);
    }
    if (has_above && has_below) return;
    hull_.dimension = has_above || has_below ? 3 : 2;
    const auto turn = [&] { normal = {Integer(-normal[0]), Integer(-normal[1]), Integer(-normal[2])}; };
    if (has_above) turn();
    if (hull_.dimension == 2) {
      const auto size = [](const Integer& value) { return value < 0 ? Integer(-value) : value; };
      const Integer largest = *std::max_element(normal.begin(), normal.end(), [&](const Integer& p, const Integer& q) {
        return size(p) < size(q);  // the first of equal ones
      });
      if (largest < 0) turn();
    }
    if (planes_.insert(on).second) add_facet(on, normal);
  }

  // Whether nothing in the plane lies right of a-b, and nothing beyond its ends.
  bool is_side(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& on, const Point& normal) const {
    return std::all_of(on.begin(), on.end(), [&](std::uint32_t c) {
      const Point &p = points_[a], &q = points_[b], &r = points_[c];
      const Wide left = dot(cross(minus(q, p), minus(r, p)), normal);
      return left > 0 || (left == 0 && dot(minus(r, p), minus(r, q)) <= 0);
    });
  }

  void add_facet(const std::vector<std::uint32_t>& on, const Point& normal) {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const std::uint32_t a : on)
      for (const std::uint32_t b : on)
        if (a != b && is_side(a, b, on, normal)) next[a] = b;
    std::vector<std::uint32_t> facet{next.begin()->first};
    for (std::uint32_t at = next[facet[0]]; at != facet[0] && facet.size() <= next.size(); at = next[at])
      facet.push_back(at);
    hull_.vertices.insert(hull_.vertices.end(), facet.begin(), facet.end());
    hull_.facets.insert(std::move(facet));
  }

  void add_ends() {
    const auto [low, high] = std::minmax_element(
        first_.begin(), first_.end(), [&](std::uint32_t i, std::uint32_t j) { return points_[i] < points_[j]; });
    hull_.vertices = {*low, *high};
  }

  std::span<const Point> points_;
  std::vector<std::uint32_t> first_;  // of equal points
  std::set<std::vector<std::uint32_t>> planes_;
  BruteHull hull_;
};

using GridPoint = std::array<std::int64_t, 3>;  // below 2^24 in magnitude

// Of equal points the lowest number counts. Cost: O(n^4).
BruteHull brute_hull(std::span<const GridPoint> points);

}  // namespace ryosen::test
