// Conversion of colours for the shaders.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/colour.h"

namespace ryosen {

inline glm::vec4 unit(Rgba c) {
  return glm::vec4(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                   static_cast<float>(c[3])) /
         255.0f;
}

// Linear light with gamma 2 (the shader converts back by a square root): close to the sRGB curve and cheap.
inline glm::vec4 linear(Rgba c) {
  const glm::vec4 v = unit(c);
  return {v.x * v.x, v.y * v.y, v.z * v.z, v.w};
}

}  // namespace ryosen
