// Which pixels things in mesh space can touch.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "core/view/size.h"

namespace ryosen {

// A box in single precision, relative to the origin of the buffers.
struct DrawBox {
  glm::vec3 min{std::numeric_limits<float>::infinity()};
  glm::vec3 max{-std::numeric_limits<float>::infinity()};

  void add(const glm::vec3& p);
  void add(const DrawBox& b);
  bool empty() const { return !(min.x <= max.x); }
};

// The smallest rectangle that holds the pixels of all points, widened by `reach` pixels on each side and cut to the
// view. The whole view when a point lies behind the near plane; empty when there is no point.
PixelRect screen_bounds(std::span<const glm::vec3> points, const glm::mat4& clip_from_mesh, Size view, float reach);
PixelRect screen_bounds(const DrawBox& box, const glm::mat4& clip_from_mesh, Size view, float reach);

}  // namespace ryosen
