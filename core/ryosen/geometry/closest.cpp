#include "ryosen/geometry/closest.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace ryosen {

namespace {

using Spanned = std::span<const glm::dvec3>;
using glm::dvec3;

dvec3 closest_on_segment(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 along = b - a;
  const double square = glm::dot(along, along);
  return square > 0 ? a + std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) * along : a;
}

// The foot of the normal through p where it lies in the triangle.
std::optional<dvec3> foot_in_triangle(const dvec3& p, Spanned t) {
  const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double square = glm::dot(normal, normal);
  if (!(square > 0)) return std::nullopt;
  const dvec3 foot = p - glm::dot(p - t[0], normal) / square * normal;
  for (std::size_t k = 0; k < 3; ++k)
    if (glm::dot(glm::cross(t[(k + 1) % 3] - t[k], foot - t[k]), normal) < 0) return std::nullopt;
  return foot;
}

// Where a segment crosses a triangle other than in its plane.
std::optional<dvec3> crossing(const dvec3& a, const dvec3& b, Spanned t) {
  const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double before = glm::dot(a - t[0], normal), behind = glm::dot(b - t[0], normal);
  if (before * behind > 0 || before == behind) return std::nullopt;
  return foot_in_triangle(a + before / (before - behind) * (b - a), t);
}

std::size_t sides_of(Spanned corners) { return corners.size() == 3 ? 3 : corners.size() - 1; }
const dvec3& end_of_side(Spanned corners, std::size_t side) { return corners[(side + 1) % corners.size()]; }

// The closest points of two segments; of parallel ones a pair with an end.
ShortestWay between_segments(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  const dvec3 u = b - a, v = d - c, w = a - c;
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), scale = uu * vv - uv * uv;
  const double s = scale > 0 ? std::clamp((uv * glm::dot(v, w) - vv * glm::dot(u, w)) / scale, 0.0, 1.0) : 0.0;
  const dvec3 to = closest_on_segment(a + s * u, c, d), from = closest_on_segment(to, a, b);
  return {from, to, glm::distance(from, to)};
}

class WaySearch {
 public:
  void take(const dvec3& from, const dvec3& to) {
    if (const double length = glm::distance(from, to); length < best_.length) best_ = {from, to, length};
  }
  // From the corners of one to the inside of the other, and where sides of one cross it.
  void into(Spanned a, Spanned t, bool is_swapped) {
    if (t.size() != 3) return;
    const auto put = [&](const dvec3& from, const dvec3& to) { is_swapped ? take(to, from) : take(from, to); };
    for (const dvec3& corner : a)
      if (const auto foot = foot_in_triangle(corner, t)) put(corner, *foot);
    for (std::size_t k = 0; k < sides_of(a); ++k)
      if (const auto place = crossing(a[k], end_of_side(a, k), t)) put(*place, *place);
  }
  void between_sides(Spanned a, Spanned b) {
    for (const dvec3& p : a)
      for (const dvec3& q : b) take(p, q);
    for (std::size_t i = 0; i < sides_of(a); ++i)
      for (const dvec3& q : b) take(closest_on_segment(q, a[i], end_of_side(a, i)), q);
    for (std::size_t k = 0; k < sides_of(b); ++k)
      for (const dvec3& p : a) take(p, closest_on_segment(p, b[k], end_of_side(b, k)));
    for (std::size_t i = 0; i < sides_of(a); ++i)
      for (std::size_t k = 0; k < sides_of(b); ++k) {
        const ShortestWay way = between_segments(a[i], end_of_side(a, i), b[k], end_of_side(b, k));
        take(way.from, way.to);
      }
  }
  const ShortestWay& best() const { return best_; }

 private:
  ShortestWay best_{{}, {}, std::numeric_limits<double>::infinity()};
};

}  // namespace

ShortestWay shortest_way(Spanned a, Spanned b) {
  WaySearch search;
  search.between_sides(a, b);
  search.into(a, b, false);
  search.into(b, a, true);
  return search.best();
}

}  // namespace ryosen
