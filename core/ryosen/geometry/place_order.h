// An order of places, for sorting.
#pragma once

#include <glm/vec3.hpp>

namespace ryosen {

// By x, then y, then z; of finite places.
inline bool is_before(const glm::dvec3& p, const glm::dvec3& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

}  // namespace ryosen
