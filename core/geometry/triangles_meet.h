// Whether two triangles in space have a point in common besides the corners and sides that they share.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace ryosen {

// A triangle whose corners are known by number. Bit k of `sides` says that the segment from corner k to the next is a
// side that a neighbour may share; no bit: it is a diagonal within a face.
struct NumberedTriangle {
  std::array<glm::dvec3, 3> places;
  std::array<std::uint32_t, 3> numbers;
  std::uint8_t sides = 7;
};

// True if and only if the closed triangles have a common point outside of what they share: corners of equal number, and
// segments between two of them that are sides of both. Touching counts, also in a single point, and so do overlap within
// one plane, the fold of two triangles over their common side, and three equal numbers. Exact for all finite doubles.
// Equal numbers must have equal places, and neither triangle may be flat (its corners on one line). About a hundred
// nanoseconds where filters decide.
bool meet_elsewhere(const NumberedTriangle& a, const NumberedTriangle& b);

}  // namespace ryosen
