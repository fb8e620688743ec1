// Exact geometric predicates for any finite doubles: orientation, collinearity, and the order of half-planes around an
// edge.
//
// Results are exact for the given doubles, including subnormals and values near the largest double. A floating-point
// filter decides nearly all calls; the rest use expansions [Shewchuk97] or, outside their safe range, a fixed-point
// accumulator wide enough for every product of doubles [Kulisch08]. Precondition: coordinates are finite (others give
// 0, or "collinear"). No allocation; a few nanoseconds if the filter decides, below half a microsecond otherwise
// (orient3d: a few microseconds).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

// +1 if a, b, c are counter-clockwise (c is left of the line from a to b), -1 if clockwise, 0 if collinear.
int orient2d(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

// +1 if d is on the side of the plane through a, b, c from which they appear counter-clockwise, -1 if on the other, 0
// if coplanar (also if a, b, c are collinear).
int orient3d(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

// The vector from one point to another, as these two: so it is exact where its coordinates cannot be.
struct Difference {
  glm::dvec3 from, to;
};

// Sign of the determinant of three rows u, v, w: +1 where w is on the side of u and v from which u turns
// counter-clockwise to v.
int determinant_sign(const Difference& u, const Difference& v, const Difference& w);

// Sign of the length of u less that of v.
int compare_lengths(const Difference& u, const Difference& v);

// The projection along an axis (0, 1, 2), seen from its tip; exact.
inline glm::dvec2 seen_along(const glm::dvec3& p, int axis) {
  return axis == 0 ? glm::dvec2(p.y, p.z) : axis == 1 ? glm::dvec2(p.z, p.x) : glm::dvec2(p.x, p.y);
}

// Sign of component `axis` (0, 1, 2) of the cross product (b - a) x (c - a).
int cross_component_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int axis);

// Whether three points are collinear or coincide.
bool are_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Whether all points are collinear or coincide; true for fewer than three points. O(n).
bool are_collinear(std::span<const glm::dvec3> points);

// The same for the positions of a face's corners.
bool are_collinear(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> corners);

// Exact order of half-planes around their common edge, by angle.
//
//        2 | /1
//          |/          seen from the end of the edge, towards its start: half-planes in the order of their angles from
//    ------+------ 0   the first one, counter-clockwise
//         /|
//       3/ |
//
// Compares half-planes that end in the line of an edge, each given by a point in it. The points are finite and not
// collinear with the edge. Angles are from the first half-plane, from 0 to below 2 pi. Exact; O(1).
class AroundEdge {
 public:
  AroundEdge(const glm::dvec3& start, const glm::dvec3& end, const glm::dvec3& first)
      : start_(start), end_(end), first_(first) {}

  // The sign of the angle of one half-plane less that of another: 0 where they are the same.
  int compare(const glm::dvec3& one, const glm::dvec3& other) const;

 private:
  // 0 for the first half-plane itself, 1 before half a turn, 2 at it, 3 after it.
  int part_of(const glm::dvec3& through) const;
  // +1 where `other` lies less than half a turn counter-clockwise of `one`, 0 in one plane.
  int turn(const glm::dvec3& one, const glm::dvec3& other) const;

  glm::dvec3 start_, end_, first_;
};

}  // namespace ryosen
