#include "ryosen/geometry/triangles_meet.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

using Corners = std::array<glm::dvec3, 3>;

// Whether both signs occur: the point or line then misses the triangle.
bool has_both_signs(int a, int b, int c) { return (a > 0 || b > 0 || c > 0) && (a < 0 || b < 0 || c < 0); }

// An axis along which the projection of a non-degenerate triangle is non-degenerate.
int view_axis(const Corners& t) {
  int axis = 0;
  while (axis < 2 && cross_component_sign(t[0], t[1], t[2], axis) == 0) ++axis;
  return axis;
}

bool covers(const Corners& t, const glm::dvec3& p, int axis) {
  return !has_both_signs(cross_component_sign(t[0], t[1], p, axis), cross_component_sign(t[1], t[2], p, axis),
                         cross_component_sign(t[2], t[0], p, axis));
}

// Segment and side must not be collinear.
bool segments_cross(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b, int axis) {
  const int side_a = cross_component_sign(p, q, a, axis), side_b = cross_component_sign(p, q, b, axis);
  if (side_a * side_b > 0 || (side_a == 0 && side_b == 0)) return false;
  return cross_component_sign(a, b, p, axis) * cross_component_sign(a, b, q, axis) <= 0;
}

// A segment coplanar with the triangle. If collinear with a side it either ends in the triangle or crosses the other
// two sides at their ends.
bool meets_in_plane(const glm::dvec3& p, const glm::dvec3& q, const Corners& t) {
  const int axis = view_axis(t);
  if (covers(t, p, axis) || covers(t, q, axis)) return true;
  for (std::size_t k = 0; k < 3; ++k)
    if (segments_cross(p, q, t[k], t[(k + 1) % 3], axis)) return true;
  return false;
}

// Whether a closed segment meets a closed triangle, given the orient3d signs of its ends.
bool meets(const glm::dvec3& p, int side_p, const glm::dvec3& q, int side_q, const Corners& t) {
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return meets_in_plane(p, q, t);
  const int first = orient3d(p, q, t[0], t[1]), second = orient3d(p, q, t[1], t[2]);
  if (first * second < 0) return false;
  return !has_both_signs(first, second, orient3d(p, q, t[2], t[0]));
}

bool same_side(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

bool has_side_that_meets(const Corners& a, const std::array<int, 3>& sides, const Corners& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    if (meets(a[k], sides[k], a[n], sides[n], b)) return true;
  }
  return false;
}

// Without common corners: triangles meet iff a side of one meets the other.
bool meet_apart(const Corners& a, const Corners& b) {
  std::array<int, 3> a_sides, b_sides;
  for (std::size_t k = 0; k < 3; ++k) a_sides[k] = orient3d(b[0], b[1], b[2], a[k]);
  if (same_side(a_sides)) return false;
  for (std::size_t k = 0; k < 3; ++k) b_sides[k] = orient3d(a[0], a[1], a[2], b[k]);
  if (same_side(b_sides)) return false;
  return has_side_that_meets(a, a_sides, b) || has_side_that_meets(b, b_sides, a);
}

// Whether a plane through a corner that triangles share has each of them on a side of its own. The bound is that of a
// sum of three products of differences with room to spare, and larger than what underflows; of what overflows it is
// infinite. False says nothing.
bool are_surely_parted_at(const glm::dvec3& corner, const std::array<glm::dvec3, 2>& a,
                          const std::array<glm::dvec3, 2>& b, const glm::dvec3& normal) {
  const auto is_surely_above = [&](const glm::dvec3& p, double sign) {
    const double x = normal.x * (p.x - corner.x), y = normal.y * (p.y - corner.y), z = normal.z * (p.z - corner.z);
    return sign * (x + y + z) > 0x1p-50 * (std::abs(x) + std::abs(y) + std::abs(z)) + 1e-290;
  };
  return is_surely_above(a[0], 1) && is_surely_above(a[1], 1) && is_surely_above(b[0], -1) && is_surely_above(b[1], -1);
}

// The plane across the difference of both ways from the corner, and of spokes that lie near each other and are not
// equally long, across that of their directions.
bool are_surely_parted_at(const glm::dvec3& corner, const std::array<glm::dvec3, 2>& a,
                          const std::array<glm::dvec3, 2>& b) {
  const glm::dvec3 to_a = (a[0] - corner) + (a[1] - corner), to_b = (b[0] - corner) + (b[1] - corner);
  if (are_surely_parted_at(corner, a, b, to_a - to_b)) return true;
  const double longer = std::sqrt(glm::dot(to_b, to_b) / glm::dot(to_a, to_a));
  return are_surely_parted_at(corner, a, b, longer * to_a - to_b);
}

// With one common corner, i of one and j of the other: the ray from it through any other common point leaves one
// triangle first, and the opposite side it leaves through meets the other triangle.
bool meet_beside_corner(const Corners& a, std::size_t i, const Corners& b, std::size_t j) {
  if (are_surely_parted_at(a[i], {a[(i + 1) % 3], a[(i + 2) % 3]}, {b[(j + 1) % 3], b[(j + 2) % 3]})) return false;
  // The side across from the corner, and where its ends are seen from the other triangle.
  struct Side {
    const glm::dvec3 &p, &q;
    int of_p, of_q;

    Side(const Corners& one, std::size_t corner, const Corners& other)
        : p(one[(corner + 1) % 3]),
          q(one[(corner + 2) % 3]),
          of_p(orient3d(other[0], other[1], other[2], p)),
          of_q(orient3d(other[0], other[1], other[2], q)) {}
    bool is_beside() const { return of_p * of_q > 0; }
  };
  // All of a triangle but the corner may lie beside the plane of the other.
  const Side of_a(a, i, b);
  if (of_a.is_beside()) return false;
  const Side of_b(b, j, a);
  if (of_b.is_beside()) return false;
  return meets(of_a.p, of_a.of_p, of_a.q, of_a.of_q, b) || meets(of_b.p, of_b.of_p, of_b.q, of_b.of_q, a);
}

// With a common side: only if the triangles are coplanar and folded onto each other. Along no axis are they seen on
// both sides of it then; of flat parts that tells quickly.
bool overlap_beside_side(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (cross_component_sign(p, q, a, axis) * cross_component_sign(p, q, b, axis) < 0) return false;
  return orient3d(p, q, a, b) == 0;
}

// Whether the segment opposite corner k is a side.
bool is_side_across(std::uint8_t sides, std::size_t k) { return (sides >> (k + 1) % 3 & 1u) != 0; }

}  // namespace

bool meet_elsewhere(const NumberedTriangle& a, const NumberedTriangle& b) {
  std::size_t common = 0, a_sum = 0, b_sum = 0;  // of the corners in common
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a.numbers[i] == b.numbers[j]) {
        ++common;
        a_sum += i;
        b_sum += j;
      }
  if (common == 0) return meet_apart(a.places, b.places);
  if (common == 1) return meet_beside_corner(a.places, a_sum, b.places, b_sum);
  if (common >= 3) return true;
  const std::size_t i = 3 - a_sum, j = 3 - b_sum;  // the corners that they do not share
  if (!is_side_across(a.sides, i) || !is_side_across(b.sides, j)) return true;
  return overlap_beside_side(a.places[(i + 1) % 3], a.places[(i + 2) % 3], a.places[i], b.places[j]);
}

}  // namespace ryosen
