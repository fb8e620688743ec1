// Rounding of places to single precision, as files and graphics cards keep them.
#pragma once

#include <glm/vec3.hpp>

namespace ryosen {

// Through volatile: g++ 12 at -O2 may drop the way to float and back of several numbers at once.
inline double to_single(double x) {
  const volatile float rounded = static_cast<float>(x);
  return rounded;
}
inline glm::dvec3 to_single(const glm::dvec3& p) { return {to_single(p.x), to_single(p.y), to_single(p.z)}; }

}  // namespace ryosen
