// Fast tests that tell for certain that two things have no common point.
#pragma once

#include <array>

#include "ryosen/geometry/box.h"

namespace ryosen {

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

}  // namespace ryosen
