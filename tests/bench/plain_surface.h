// A surface of triangles and the nearest of them to a point, by a plain grid that shares nothing with what is measured.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "tests/bench/plain_off.h"

namespace plain {

using Point = std::array<double, 3>;

inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point along(const Point& a, const Point& d, double t) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}

inline double square_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = minus(b, a);
  const double length = dot(d, d);
  const double t = length > 0 ? std::clamp(dot(minus(p, a), d) / length, 0.0, 1.0) : 0.0;
  const Point r = minus(p, along(a, d, t));
  return dot(r, r);
}

class Surface {
 public:
  explicit Surface(Triangles mesh) : mesh_(std::move(mesh)) {
    for (const auto& face : mesh_.faces)
      for (const std::uint32_t corner : face)
        for (std::size_t i = 0; i < 3; ++i) {
          low_[i] = std::min(low_[i], mesh_.points[corner][i]);
          high_[i] = std::max(high_[i], mesh_.points[corner][i]);
        }
    const Point size = minus(high_, low_);
    diagonal_ = std::sqrt(dot(size, size));
    width_ = std::max(diagonal_ / 400, diagonal_ / (2 * std::sqrt(double(mesh_.faces.size()) + 1)));
    for (std::size_t i = 0; i < 3; ++i) count_[i] = static_cast<int>(size[i] / width_) + 1;
    cells_.resize(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]));
    for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) put(f);
  }

  double diagonal() const { return diagonal_; }
  const Triangles& mesh() const { return mesh_; }
  std::array<Point, 3> corners(std::uint32_t f) const {
    const auto& [a, b, c] = mesh_.faces[f];
    return {mesh_.points[a], mesh_.points[b], mesh_.points[c]};
  }
  Point normal(std::uint32_t f) const {
    const auto [a, b, c] = corners(f);
    return cross(minus(b, a), minus(c, a));
  }

  struct Nearest {
    double square = std::numeric_limits<double>::infinity();
    std::uint32_t face = 0;
  };
  // Looks in shells of cells around the point until the next one is farther away than what was found.
  Nearest nearest(const Point& p) const {
    std::array<int, 3> at{};
    for (std::size_t i = 0; i < 3; ++i)
      at[i] = static_cast<int>(std::clamp(std::floor((p[i] - low_[i]) / width_), 0.0, double(count_[i] - 1)));
    Nearest best;
    for (int shell = 0; shell <= std::max({count_[0], count_[1], count_[2]}); ++shell) {
      const double least = (shell - 1) * width_;  // of the cells of this shell, for points in the box or outside
      if (shell > 1 && best.square <= least * least) break;
      visit_shell(at, shell, [&](const std::vector<std::uint32_t>& faces) {
        for (const std::uint32_t f : faces)
          if (const double square = square_to(p, f); square < best.square) best = {square, f};
      });
    }
    return best;
  }

 private:
  std::size_t index(int i, int j, int k) const {
    return (std::size_t(k) * std::size_t(count_[1]) + std::size_t(j)) * std::size_t(count_[0]) + std::size_t(i);
  }

  void put(std::uint32_t f) {
    const auto [a, b, c] = corners(f);
    std::array<int, 3> first{}, last{};
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] = static_cast<int>((std::min({a[i], b[i], c[i]}) - low_[i]) / width_);
      last[i] = std::min(static_cast<int>((std::max({a[i], b[i], c[i]}) - low_[i]) / width_), count_[i] - 1);
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i) cells_[index(i, j, k)].push_back(f);
  }

  template <class Visit>
  void visit_shell(const std::array<int, 3>& at, int shell, const Visit& visit) const {
    for (int k = std::max(at[2] - shell, 0); k <= std::min(at[2] + shell, count_[2] - 1); ++k)
      for (int j = std::max(at[1] - shell, 0); j <= std::min(at[1] + shell, count_[1] - 1); ++j) {
        const bool is_side = std::abs(k - at[2]) == shell || std::abs(j - at[1]) == shell;
        for (int i = at[0] - shell; i <= at[0] + shell; i += is_side || shell == 0 ? 1 : 2 * shell)
          if (i >= 0 && i < count_[0]) visit(cells_[index(i, j, k)]);
      }
  }

  double square_to(const Point& p, std::uint32_t f) const {
    const auto [a, b, c] = corners(f);
    const Point n = cross(minus(b, a), minus(c, a));
    const bool is_above = dot(n, n) > 0 && dot(cross(minus(b, a), minus(p, a)), n) >= 0 &&
                          dot(cross(minus(c, b), minus(p, b)), n) >= 0 && dot(cross(minus(a, c), minus(p, c)), n) >= 0;
    if (is_above) return std::pow(dot(minus(p, a), n), 2) / dot(n, n);
    return std::min({square_to_segment(p, a, b), square_to_segment(p, b, c), square_to_segment(p, c, a)});
  }

  Triangles mesh_;
  Point low_{1e300, 1e300, 1e300}, high_{-1e300, -1e300, -1e300};
  double diagonal_ = 0, width_ = 1;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<std::vector<std::uint32_t>> cells_;
};

// Calls visit(face, place, shares of its corners) for random places, each face as often as its share of the area.
template <class Visit>
void visit_random_places(const Surface& surface, std::size_t places, const Visit& visit) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> areas;
  double area = 0;
  for (std::uint32_t f = 0; f < surface.mesh().faces.size(); ++f) {
    const Point n = surface.normal(f);
    area += std::sqrt(dot(n, n));
    areas.push_back(area);
  }
  for (std::size_t i = 0; i < places; ++i) {
    const auto f = static_cast<std::uint32_t>(
        std::min<std::ptrdiff_t>(std::lower_bound(areas.begin(), areas.end(), unit(random) * area) - areas.begin(),
                                 static_cast<std::ptrdiff_t>(areas.size()) - 1));
    const auto [a, b, c] = surface.corners(f);
    const double root = std::sqrt(unit(random)), t = unit(random);
    const double second = root * (1 - t), third = root * t;
    visit(f, along(along(a, minus(b, a), second), minus(c, a), third), Point{1 - second - third, second, third});
  }
}

}  // namespace plain
