// Exact order of half-planes around their common edge, by angle.
//
//        2 | /1
//          |/          seen from the end of the edge, towards its start: half-planes in the order of their angles from
//    ------+------ 0   the first one, counter-clockwise
//         /|
//       3/ |
#pragma once

#include <glm/vec3.hpp>

namespace ryosen {

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
