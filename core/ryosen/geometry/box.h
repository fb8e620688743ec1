// An axis-aligned bounding box in space, in doubles.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "ryosen/geometry/is_finite.h"

namespace ryosen {

// Holds nothing at first.
struct Box {
  glm::dvec3 lowest{std::numeric_limits<double>::infinity()};
  glm::dvec3 highest{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    lowest = glm::min(lowest, p);
    highest = glm::max(highest, p);
  }
  void add(const Box& box) {
    lowest = glm::min(lowest, box.lowest);
    highest = glm::max(highest, box.highest);
  }
  bool is_empty() const { return !(lowest.x <= highest.x); }
  glm::dvec3 middle() const { return 0.5 * lowest + 0.5 * highest; }
  // Touching counts.
  bool overlaps(const Box& b) const {
    for (int axis = 0; axis < 3; ++axis)
      if (highest[axis] < b.lowest[axis] || b.highest[axis] < lowest[axis]) return false;
    return true;
  }
  bool encloses(const Box& b) const {
    for (int axis = 0; axis < 3; ++axis)
      if (b.lowest[axis] < lowest[axis] || highest[axis] < b.highest[axis]) return false;
    return true;
  }
};

inline Box box_of(std::span<const glm::dvec3> points) {
  Box box;
  for (const glm::dvec3& p : points) box.add(p);
  return box;
}

// Of those that are finite.
inline Box box_of_finite(std::span<const glm::dvec3> points) {
  Box box;
  for (const glm::dvec3& p : points)
    if (is_finite(p)) box.add(p);
  return box;
}

}  // namespace ryosen
