#include "ryosen/geometry/around_edge.h"

#include "ryosen/geometry/predicates.h"

namespace ryosen {

int AroundEdge::turn(const glm::dvec3& one, const glm::dvec3& other) const {
  return determinant_sign({start_, end_}, {start_, one}, {start_, other});
}

int AroundEdge::part_of(const glm::dvec3& through) const {
  if (const int sign = turn(first_, through)) return sign > 0 ? 1 : 3;
  for (int axis = 0; axis < 3; ++axis)
    if (const int sign = cross_component_sign(start_, end_, first_, axis))
      return sign == cross_component_sign(start_, end_, through, axis) ? 0 : 2;
  return 0;
}

int AroundEdge::compare(const glm::dvec3& one, const glm::dvec3& other) const {
  const int part = part_of(one), other_part = part_of(other);
  if (part != other_part) return part < other_part ? -1 : 1;
  return part == 0 || part == 2 ? 0 : -turn(one, other);
}

}  // namespace ryosen
