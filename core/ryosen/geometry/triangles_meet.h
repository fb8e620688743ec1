// Exact test whether two triangles in space intersect other than at shared corners and sides.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

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

}  // namespace ryosen
