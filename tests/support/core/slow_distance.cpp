#include "tests/support/core/slow_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ryosen::test {

namespace {

struct Long3 {
  long double x, y, z;
};
Long3 minus(const glm::dvec3& a, const glm::dvec3& b) {
  return {static_cast<long double>(a.x) - b.x, static_cast<long double>(a.y) - b.y,
          static_cast<long double>(a.z) - b.z};
}
long double product(const Long3& a, const Long3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
// |w - s u - t v|
long double rest(const Long3& w, const Long3& u, long double s, const Long3& v, long double t) {
  const Long3 r{w.x - s * u.x - t * v.x, w.y - s * u.y - t * v.y, w.z - s * u.z - t * v.z};
  return std::sqrt(product(r, r));
}

}  // namespace

long double slow_distance(const glm::dvec3& p, const SlowTriangle& t) {
  long double least = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Long3 w = minus(p, t[i]), u = minus(t[(i + 1) % 3], t[i]);
    const long double square = product(u, u);
    const long double s = square > 0 ? std::clamp(product(w, u) / square, 0.0L, 1.0L) : 0.0L;
    least = std::min(least, rest(w, u, s, u, 0));
  }
  const Long3 w = minus(p, t[0]), u = minus(t[1], t[0]), v = minus(t[2], t[0]);
  const long double uu = product(u, u), uv = product(u, v), vv = product(v, v), wu = product(w, u), wv = product(w, v);
  const long double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return least;
  const long double a = (wu * vv - wv * uv) / determinant, b = (wv * uu - wu * uv) / determinant;
  return a >= 0 && b >= 0 && a + b <= 1 ? std::min(least, rest(w, u, a, v, b)) : least;
}

long double slow_distance(const glm::dvec3& p, const std::vector<SlowTriangle>& triangles) {
  long double least = std::numeric_limits<long double>::infinity();
  for (const SlowTriangle& t : triangles) least = std::min(least, slow_distance(p, t));
  return least;
}

SlowFigures slow_figures(const std::vector<SlowTriangle>& from, const std::vector<SlowTriangle>& to, int k) {
  SlowFigures figures;
  long double area = 0, sum = 0, squares = 0;
  for (const SlowTriangle& t : from) {
    const Long3 u = minus(t[1], t[0]), v = minus(t[2], t[0]);
    const long double whole =
        std::sqrt(std::max(0.0L, product(u, u) * product(v, v) - product(u, v) * product(u, v))) / 2;
    const long double weight = whole / (static_cast<long double>(k) * k);
    const auto add = [&](long double i, long double j) {
      const auto a = static_cast<double>(i / k), b = static_cast<double>(j / k);
      const auto distance = slow_distance((1 - a - b) * t[0] + a * t[1] + b * t[2], to);
      area += weight;
      sum += weight * distance;
      squares += weight * distance * distance;
      figures.largest = std::max(figures.largest, static_cast<double>(distance));
    };
    for (int i = 0; i < k; ++i)
      for (int j = 0; i + j < k; ++j) {
        add(i + 1 / 3.0L, j + 1 / 3.0L);
        if (i + j + 1 < k) add(i + 2 / 3.0L, j + 2 / 3.0L);
      }
    for (std::size_t i = 0; i < 3; ++i) {
      const Long3 side = minus(t[(i + 1) % 3], t[i]);
      figures.reach = std::max(figures.reach, static_cast<double>(std::sqrt(product(side, side)) / k));
    }
  }
  figures.mean = static_cast<double>(sum / area);
  figures.rms = static_cast<double>(std::sqrt(squares / area));
  return figures;
}

}  // namespace ryosen::test
