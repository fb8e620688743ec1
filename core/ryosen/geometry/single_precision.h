// Single precision, as files and graphics cards keep numbers: rounding to it, and numbers in double precision that
// stand for floats.
#pragma once

#include <glm/vec3.hpp>

namespace ryosen {

// Through volatile: g++ 12 at -O2 may drop the way to float and back of several numbers at once.
inline double to_single(double x) {
  const volatile float rounded = static_cast<float>(x);
  return rounded;
}
inline glm::dvec3 to_single(const glm::dvec3& p) { return {to_single(p.x), to_single(p.y), to_single(p.z)}; }

// Whether the value is a float, or a decimal that the nearest float gives when it is printed with as many digits. Every
// decimal of up to six digits is one, and so are infinities; a number beyond the range of floats is none.
bool is_decimal_of_single(double value);

}  // namespace ryosen
