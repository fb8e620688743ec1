// Conservative screen bounds of points and boxes.
#pragma once

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "ryosen/scene/view/size.h"

namespace ryosen {

// An axis-aligned bounding box in buffer space, single precision.
struct DrawBox {
  glm::vec3 min{std::numeric_limits<float>::infinity()};
  glm::vec3 max{-std::numeric_limits<float>::infinity()};

  void add(const glm::vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void add(const DrawBox& b) {
    min = glm::min(min, b.min);
    max = glm::max(max, b.max);
  }
  bool empty() const { return !(min.x <= max.x); }
  // One of the eight: a bit of its number for each axis, set where that is at its largest.
  glm::vec3 corner(std::size_t i) const {
    return {(i & 1) ? max.x : min.x, (i & 2) ? max.y : min.y, (i & 4) ? max.z : min.z};
  }
};

// The bounding rectangle of the projected points, widened by `reach` pixels on each side and clipped to the view. The
// whole view if a point is in front of the near plane; empty without points.
PixelRect screen_bounds(std::span<const glm::vec3> points, const glm::mat4& clip_from_mesh, Size view, float reach);
PixelRect screen_bounds(const DrawBox& box, const glm::mat4& clip_from_mesh, Size view, float reach);

}  // namespace ryosen
