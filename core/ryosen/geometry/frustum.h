// Frusta: convex regions bounded by planes, such as the region seen through a pixel.
#pragma once

#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "ryosen/geometry/box.h"

namespace ryosen {

// The points p with dot(plane.xyz, p) + plane.w >= 0 for the first `count` planes; without planes all of space.
// Planes need no unit length.
struct Frustum {
  static constexpr std::size_t most_planes = 12;
  std::array<glm::dvec4, most_planes> planes{};
  std::size_t count = 0;

  void add(const glm::dvec4& plane) { planes[count++] = plane; }
};

// The inside of a box.
Frustum frustum_of_box(const Box& box);

// The region seen through a screen rectangle, given by two corners in normalized device coordinates (-1 to 1, y up).
// Bounded by the near plane of an OpenGL projection, not by the far plane.
Frustum frustum_of_rectangle(const glm::dmat4& clip_from_world, const glm::dvec2& lowest, const glm::dvec2& highest);

// The square of half side `radius_px` around a pixel position (y down, in a viewport of `size_px`).
Frustum frustum_around_pixel(const glm::dmat4& clip_from_world, const glm::dvec2& size_px, const glm::dvec2& pixel,
                             double radius_px);

}  // namespace ryosen
