// Polygons for tests: gentle ones, nasty ones, and random simple ones with many equal coordinates.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "ryosen/geometry/predicates.h"

namespace ryosen::test_shapes {

using Polygon = std::vector<glm::dvec3>;

// Star-shaped around the origin, radii random between 0.1 and 1.
inline Polygon star(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  Polygon result;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double r = radius(random);
    result.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
  }
  return result;
}

// A corridor that winds inwards: out along one wall, back along the other.
inline Polygon spiral(std::size_t count, double turns) {
  Polygon result;
  const std::size_t half = count / 2;
  const auto wall = [&](std::size_t i, double offset) {
    const double t = static_cast<double>(i) / static_cast<double>(half);
    const double angle = 2.0 * std::numbers::pi * turns * t;
    const double r = 1.0 + offset + turns * t;
    result.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
  };
  for (std::size_t i = 0; i < half; ++i) wall(i, 0.5);
  for (std::size_t i = half; i-- > 0;) wall(i, 0.0);
  return result;
}

// A spine with teeth that end at random heights on integer coordinates; runs of collinear corners along the spine.
inline Polygon comb(std::size_t teeth, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> height(1, 5);
  Polygon result;
  for (std::size_t i = 0; i <= 2 * teeth; ++i) result.emplace_back(static_cast<double>(i), -1.0, 0.0);
  for (std::size_t i = teeth; i-- > 0;) {
    const auto x = static_cast<double>(2 * i);
    const double h = height(random);
    result.emplace_back(x + 2, 0.0, 0.0);
    result.emplace_back(x + 2, h, 0.0);
    result.emplace_back(x + 1, h, 0.0);
    result.emplace_back(x + 1, 0.0, 0.0);
  }
  result.emplace_back(0.0, 0.0, 0.0);
  return result;
}

// Saw teeth between two lines whose tips all lie on one level.
inline Polygon saw(std::size_t teeth) {
  Polygon result;
  for (std::size_t i = 0; i < teeth; ++i) {
    result.emplace_back(static_cast<double>(2 * i), 0.0, 0.0);
    result.emplace_back(static_cast<double>(2 * i + 1), 10.0, 0.0);
  }
  result.emplace_back(static_cast<double>(2 * teeth), 0.0, 0.0);
  for (std::size_t i = teeth; i-- > 0;) {
    result.emplace_back(static_cast<double>(2 * i + 1), 11.0, 0.0);
    result.emplace_back(static_cast<double>(2 * i), 1.0, 0.0);
  }
  return result;
}

inline Polygon convex(std::size_t count) {
  Polygon result;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    result.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return result;
}

// A square of 4 * side corners with runs of collinear corners.
inline Polygon square_with_many_corners(std::size_t side) {
  Polygon result;
  const auto length = static_cast<double>(side);
  for (std::size_t i = 0; i < side; ++i) result.emplace_back(static_cast<double>(i), 0.0, 0.0);
  for (std::size_t i = 0; i < side; ++i) result.emplace_back(length, static_cast<double>(i), 0.0);
  for (std::size_t i = side; i > 0; --i) result.emplace_back(static_cast<double>(i), length, 0.0);
  for (std::size_t i = side; i > 0; --i) result.emplace_back(0.0, static_cast<double>(i), 0.0);
  return result;
}

inline int turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
}

// Whether two closed segments have a point in common, in the xy plane.
inline bool segments_meet(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const auto within = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
           r.y <= std::max(p.y, q.y);
  };
  const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) || (cda == 0 && within(c, d, a)) ||
         (cdb == 0 && within(c, d, b));
}

// Every corner once, no two sides touch except neighbours at their common corner. Quadratic.
inline bool is_simple(const Polygon& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
    if (a == b) return false;
    if (turn(a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segments_meet(a, b, p[j], p[(j + 1) % n])) return false;
    }
  }
  return true;
}

inline double signed_area(const Polygon& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::dvec3 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2.0;
}

// A simple counter-clockwise polygon on a small integer grid, or an empty one if this seed gives none: random places,
// crossings undone by turning pieces round.
inline Polygon random_simple(std::size_t count, int grid, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(0, grid);
  Polygon p;
  for (std::size_t i = 0; i < count; ++i) p.emplace_back(coordinate(random), coordinate(random), 0.0);
  for (int round = 0; round < 200 && !is_simple(p); ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 2; j < count; ++j) {
        if (i == 0 && j == count - 1) continue;
        if (segments_meet(p[i], p[i + 1], p[j], p[(j + 1) % count])) {
          std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        }
      }
    }
  }
  if (!is_simple(p)) return {};
  if (signed_area(p) < 0) std::reverse(p.begin(), p.end());
  return p;
}

}  // namespace ryosen::test_shapes
