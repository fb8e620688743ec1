// The shortest ways between points, segments and triangles in space.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

struct ShortestWay {
  glm::dvec3 from, to;
  double length;
};

// Between two of these, each given by its one, two or three corners; 0 where they meet. One without length or area
// counts as what its corners span. Coordinates are finite. Rounded.
ShortestWay shortest_way(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b);

namespace detail {

inline glm::dvec3 way_from_segment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  const glm::dvec3 along = b - a, from_a = p - a;
  const double square = glm::dot(along, along), t = glm::dot(along, from_a);
  if (!(t > 0)) return from_a;
  return t < square ? from_a - (t / square) * along : p - b;
}

// Of two ways the shorter.
inline glm::dvec3 shorter(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(b, b) < glm::dot(a, a) ? b : a; }

inline glm::dvec3 way_from_sides(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p) {
  return shorter(shorter(way_from_segment(a, b, p), way_from_segment(b, c, p)), way_from_segment(c, a, p));
}

}  // namespace detail

// p minus its nearest point in the triangle a, b, c, by the regions of [Ericson04]; exactly 0 where p is a corner. A
// triangle without area is what its corners span. Coordinates are at most about 1e75. Rounded, but never to a point
// that is outside of the triangle by more than the rounding of its coordinates, however thin it is.
inline glm::dvec3 way_from_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                    const glm::dvec3& p) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
  const double ab_ap = glm::dot(ab, ap), ac_ap = glm::dot(ac, ap);
  if (ab_ap <= 0 && ac_ap <= 0) return ap;
  const glm::dvec3 bp = p - b;
  const double ab_bp = glm::dot(ab, bp), ac_bp = glm::dot(ac, bp);
  if (ab_bp >= 0 && ac_bp <= ab_bp) return bp;
  const glm::dvec3 cp = p - c;
  const double ab_cp = glm::dot(ab, cp), ac_cp = glm::dot(ac, cp);
  if (ac_cp >= 0 && ab_cp <= ac_cp) return cp;

  // Weights of the corners at the foot of the normal, times the square of twice the area.
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double sum = glm::dot(normal, normal);
  const double of_b = glm::dot(glm::cross(ap, ac), normal), of_c = glm::dot(glm::cross(ab, ap), normal);
  const double of_a = sum - of_b - of_c;
  const bool is_inside = of_a > 0 && of_b > 0 && of_c > 0;
  // Where the sine at a is less than 1e-4 these signs may be those of rounding, and the foot is looked for again from
  // there.
  if (!(sum > 1e-8 * glm::dot(ab, ab) * glm::dot(ac, ac))) {
    const glm::dvec3 side = detail::way_from_sides(a, b, c, p);
    if (!is_inside) return side;
    const glm::dvec3 near = ap - (of_b / sum) * ab - (of_c / sum) * ac;
    const double more_b = glm::dot(glm::cross(near, ac), normal), more_c = glm::dot(glm::cross(ab, near), normal);
    return detail::shorter(side, near - (more_b / sum) * ab - (more_c / sum) * ac);
  }
  if (is_inside) return ap - (of_b / sum) * ab - (of_c / sum) * ac;
  if (of_c <= 0 && ab_ap >= 0 && ab_bp <= 0) return ap - (ab_ap / (ab_ap - ab_bp)) * ab;
  if (of_b <= 0 && ac_ap >= 0 && ac_cp <= 0) return ap - (ac_ap / (ac_ap - ac_cp)) * ac;
  const double from_b = ac_bp - ab_bp, from_c = ab_cp - ac_cp;
  if (of_a <= 0 && from_b >= 0 && from_c >= 0 && from_b + from_c > 0)
    return bp - (from_b / (from_b + from_c)) * (c - b);
  return detail::way_from_sides(a, b, c, p);
}

inline double squared(const glm::dvec3& v) { return glm::dot(v, v); }

}  // namespace ryosen
