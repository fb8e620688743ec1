#include "ryosen/geometry/triangles_meet.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

using Triangle = std::array<glm::dvec3, 3>;

// Whether both signs occur: the point or line then misses the triangle.
bool has_both_signs(int a, int b, int c) { return (a > 0 || b > 0 || c > 0) && (a < 0 || b < 0 || c < 0); }

// An axis along which the projection of a non-degenerate triangle is non-degenerate.
int view_axis(const Triangle& t) {
  int axis = 0;
  while (axis < 2 && cross_component_sign(t[0], t[1], t[2], axis) == 0) ++axis;
  return axis;
}

bool covers(const Triangle& t, const glm::dvec3& p, int axis) {
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
bool meets_in_plane(const glm::dvec3& p, const glm::dvec3& q, const Triangle& t) {
  const int axis = view_axis(t);
  if (covers(t, p, axis) || covers(t, q, axis)) return true;
  for (std::size_t k = 0; k < 3; ++k)
    if (segments_cross(p, q, t[k], t[(k + 1) % 3], axis)) return true;
  return false;
}

// Whether a closed segment meets a closed triangle, given the orient3d signs of its ends.
bool meets(const glm::dvec3& p, int side_p, const glm::dvec3& q, int side_q, const Triangle& t) {
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return meets_in_plane(p, q, t);
  const int first = orient3d(p, q, t[0], t[1]), second = orient3d(p, q, t[1], t[2]);
  if (first * second < 0) return false;
  return !has_both_signs(first, second, orient3d(p, q, t[2], t[0]));
}

bool same_side(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

bool has_side_that_meets(const Triangle& a, const std::array<int, 3>& sides, const Triangle& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    if (meets(a[k], sides[k], a[n], sides[n], b)) return true;
  }
  return false;
}

// Without common corners: triangles meet iff a side of one meets the other.
bool meet_apart(const Triangle& a, const Triangle& b) {
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
bool meet_beside_corner(const Triangle& a, std::size_t i, const Triangle& b, std::size_t j) {
  if (are_surely_parted_at(a[i], {a[(i + 1) % 3], a[(i + 2) % 3]}, {b[(j + 1) % 3], b[(j + 2) % 3]})) return false;
  // The side across from the corner, and where its ends are seen from the other triangle.
  struct Side {
    const glm::dvec3 &p, &q;
    int of_p, of_q;

    Side(const Triangle& one, std::size_t corner, const Triangle& other)
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

// orient3d in floating point; 0 if the rounding error could exceed the value.
int certain_side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const glm::dvec3 u = a - d, v = b - d, w = c - d;
  const double value = glm::dot(u, glm::cross(v, w));
  const double size = std::abs(u.x) * (std::abs(v.y * w.z) + std::abs(v.z * w.y)) +
                      std::abs(u.y) * (std::abs(v.z * w.x) + std::abs(v.x * w.z)) +
                      std::abs(u.z) * (std::abs(v.x * w.y) + std::abs(v.y * w.x));
  constexpr double relative_error = 1e-15;
  if (!(std::abs(value) > relative_error * size)) return 0;
  return value > 0 ? 1 : -1;
}

bool passes_through(const glm::dvec3& p, const glm::dvec3& q, const Triangle& t) {
  const int side_p = certain_side(t[0], t[1], t[2], p), side_q = certain_side(t[0], t[1], t[2], q);
  if (side_p * side_q != -1) return false;
  const int first = certain_side(p, q, t[0], t[1]);
  return first != 0 && first == certain_side(p, q, t[1], t[2]) && first == certain_side(p, q, t[2], t[0]);
}

glm::dvec3 normal_of(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

// Where a triangle lies in the plane through a point: the ends of a segment, or nothing.
std::vector<glm::dvec3> cut_by_plane(const Triangle& t, const glm::dvec3& point, const glm::dvec3& normal) {
  std::array<double, 3> height;
  for (std::size_t k = 0; k < 3; ++k) height[k] = glm::dot(t[k] - point, normal);
  std::vector<glm::dvec3> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (height[k] == 0)
      ends.push_back(t[k]);
    else if ((height[k] < 0) != (height[next] < 0) && height[next] != 0)
      ends.push_back(t[k] + height[k] / (height[k] - height[next]) * (t[next] - t[k]));
  }
  return ends;
}

// More than what rounds off, in units of the lengths that were added.
constexpr double margin = 1e-12;

glm::dvec3 sizes_of(const Triangle& t) { return glm::max(glm::max(glm::abs(t[0]), glm::abs(t[1])), glm::abs(t[2])); }

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

bool triangles_cross(const Triangle& a, const Triangle& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (passes_through(a[k], a[(k + 1) % 3], b) || passes_through(b[k], b[(k + 1) % 3], a)) return true;
  return false;
}

Box common_box(const Triangle& a, const Triangle& b) {
  const Box box_a = box_of(a), box_b = box_of(b);
  const Box common{glm::max(box_a.lowest, box_b.lowest), glm::min(box_a.highest, box_b.highest)};
  const glm::dvec3 normal_a = normal_of(a), normal_b = normal_of(b), along = glm::cross(normal_a, normal_b);
  constexpr double flat = 1e-9;  // the sine of the angle between planes
  if (!(glm::length(along) > flat * glm::length(normal_a) * glm::length(normal_b))) return common;
  std::vector<glm::dvec3> of_a = cut_by_plane(a, b[0], normal_b), of_b = cut_by_plane(b, a[0], normal_a);
  if (of_a.empty() || of_b.empty()) return common;
  const auto is_before = [&](const glm::dvec3& p, const glm::dvec3& q) {
    return glm::dot(p, along) < glm::dot(q, along);
  };
  const auto [low_a, high_a] = std::minmax_element(of_a.begin(), of_a.end(), is_before);
  const auto [low_b, high_b] = std::minmax_element(of_b.begin(), of_b.end(), is_before);
  Box box;
  box.add(std::max(*low_a, *low_b, is_before));
  box.add(std::min(*high_a, *high_b, is_before));
  return box.is_empty() ? common : box;
}

bool are_surely_apart(const Triangle& triangle, const Box& box) {
  if (!box.overlaps(box_of(triangle))) return true;
  const glm::dvec3 middle = box.middle(), half = 0.5 * (box.highest - box.lowest);
  const Triangle v{triangle[0] - middle, triangle[1] - middle, triangle[2] - middle};
  const glm::dvec3 reach = sizes_of(v) + half;
  const auto is_apart_along = [&](const glm::dvec3& axis) {
    const double a = glm::dot(axis, v[0]), b = glm::dot(axis, v[1]), c = glm::dot(axis, v[2]);
    const double wide = glm::dot(glm::abs(axis), half) + margin * glm::dot(glm::abs(axis), reach);
    return std::min({a, b, c}) > wide || std::max({a, b, c}) < -wide;
  };
  const Triangle sides{v[1] - v[0], v[2] - v[1], v[0] - v[2]};
  for (const glm::dvec3& e : sides)
    if (is_apart_along({0, -e.z, e.y}) || is_apart_along({e.z, 0, -e.x}) || is_apart_along({-e.y, e.x, 0})) return true;
  return is_apart_along(glm::cross(sides[0], sides[1]));
}

TriangleSlabs::TriangleSlabs(const Triangle& t) : origin_(t[0]) {
  const glm::dvec3 b = t[1] - origin_, c = t[2] - origin_, normal = glm::cross(b, c);
  reach_ = glm::max(glm::abs(b), glm::abs(c));
  const std::array axes{normal, glm::cross(normal, b), glm::cross(normal, c - b), glm::cross(normal, c)};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double at_b = glm::dot(axes[i], b), at_c = glm::dot(axes[i], c);
    slabs_[i] = {axes[i], std::min({0.0, at_b, at_c}), std::max({0.0, at_b, at_c})};
  }
}

bool TriangleSlabs::separate(const Triangle& other) const {
  const Triangle v{other[0] - origin_, other[1] - origin_, other[2] - origin_};
  const glm::dvec3 reach = glm::max(reach_, sizes_of(v));
  for (const Slab& slab : slabs_) {
    const double a = glm::dot(slab.axis, v[0]), b = glm::dot(slab.axis, v[1]), c = glm::dot(slab.axis, v[2]);
    const double wide = margin * glm::dot(glm::abs(slab.axis), reach);
    if (std::min(std::min(a, b), c) > slab.high + wide || std::max(std::max(a, b), c) < slab.low - wide) return true;
  }
  return false;
}

}  // namespace ryosen
