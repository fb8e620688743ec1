// Tests whether and where two triangles in space meet: exactly, by doubles for warnings, and quick ones that let most
// pairs be left out.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "ryosen/geometry/box.h"

namespace ryosen {

// A triangle with numbered corners. Bit k of `sides`: the segment from corner k to the next is a side that a neighbour
// may share; otherwise it is a diagonal within a face.
struct NumberedTriangle {
  std::array<glm::dvec3, 3> places;
  std::array<std::uint32_t, 3> numbers;
  std::uint8_t sides = 7;
};

// True if and only if the closed triangles have a common point outside of what they share: corners of equal number, and
// segments between two of them that are sides of both. Touching counts, even in a single point, and so do coplanar
// overlap, two triangles folded over their common side, and three equal numbers. Exact for all finite doubles. Equal
// numbers must have equal places, and neither triangle may be degenerate (collinear corners). About 100 ns if the
// filters decide.
bool meet_elsewhere(const NumberedTriangle& a, const NumberedTriangle& b);

// The plane of a triangle, in doubles: a filter before meet_elsewhere for one triangle against many.
class TrianglePlane {
 public:
  TrianglePlane() = default;
  explicit TrianglePlane(const std::array<glm::dvec3, 3>& t) : origin_(t[0]) {
    const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0];
    const glm::dvec3 first(u.y * v.z, u.z * v.x, u.x * v.y), second(u.z * v.y, u.x * v.z, u.y * v.x);
    normal_ = first - second;
    size_ = glm::abs(first) + glm::abs(second);
  }

  // True only where all three corners lie on one side of the plane, strictly; often false where they do.
  bool is_clear_of(const std::array<glm::dvec3, 3>& t) const {
    const int side = clear_side(t[0]);
    return side != 0 && clear_side(t[1]) == side && clear_side(t[2]) == side;
  }

 private:
  // As the filter of orient3d (predicates.cpp), about another corner; 0 where rounding may hide the sign.
  int clear_side(const glm::dvec3& p) const {
    const glm::dvec3 d = p - origin_, far = glm::abs(d);
    const double det = glm::dot(normal_, d), size = glm::dot(size_, far), reach = far.x + far.y + far.z;
    if (!(size > 1e-200 && size <= 1e+300 && reach < 1e+100 && std::abs(det) > 8e-16 * size)) return 0;
    return det > 0.0 ? 1 : -1;
  }

  glm::dvec3 origin_{0.0}, normal_{0.0}, size_{0.0};
};

// Whether an axis separates a triangle from a box, whatever the rounding. False says nothing. Boxes of slivers overlap
// where the slivers are far apart.
bool are_surely_apart(const std::array<glm::dvec3, 3>& triangle, const Box& box);

// A triangle of which it is asked about many: whether its normal, or a line across one of its sides in its plane,
// separates it from another one for certain.
class TriangleSlabs {
 public:
  explicit TriangleSlabs(const std::array<glm::dvec3, 3>& triangle);
  bool separate(const std::array<glm::dvec3, 3>& other) const;

 private:
  struct Slab {
    glm::dvec3 axis;
    double low, high;
  };
  glm::dvec3 origin_, reach_;
  std::array<Slab, 4> slabs_;
};

// Separates two triangles by the slabs of both, also triangles in one plane.
inline bool are_surely_apart(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b) {
  return TriangleSlabs(a).separate(b) || TriangleSlabs(b).separate(a);
}

// The box of what two triangles that meet have in common, up to rounding: of the segment in which they cross, or of
// what their boxes have in common where they lie in one plane, or rounding shows no segment. O(1).
Box common_box(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b);

// True if an edge of one certainly passes through the interior of the other. Touching, shared corners or edges and
// coplanar overlap do not count, nor cases that rounding leaves undecided: for warnings, not for combinatorial
// decisions. O(1).
bool triangles_cross(const std::array<glm::dvec3, 3>& a, const std::array<glm::dvec3, 3>& b);

}  // namespace ryosen
