// Points that span what all points span: what a hull begins with.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace ryosen::hull {

struct AffineBasis {
  int dimension = -1;                     // of what they span, exactly
  std::array<std::uint32_t, 4> points{};  // the first dimension + 1 of them; far apart where that is easily had
};

// Of distinct finite points. Cost: O(n).
AffineBasis affine_basis(std::span<const glm::dvec3> points);

struct SignedAxis {
  int axis;
  int sign;
};
// The axis along which the normal (b - a) x (c - a) is largest, the first of equal ones, and its sign there; exact. The
// points are not collinear.
SignedAxis largest_normal_axis(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace ryosen::hull
