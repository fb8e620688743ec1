#include "ryosen/geometry/frustum.h"

#include <glm/matrix.hpp>

namespace ryosen {

Frustum frustum_of_box(const Box& box) {
  Frustum sides;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 along{0.0};
    along[axis] = 1;
    sides.add({along, -box.lowest[axis]});
    sides.add({-along, box.highest[axis]});
  }
  return sides;
}

Frustum frustum_of_rectangle(const glm::dmat4& clip_from_world, const glm::dvec2& lowest, const glm::dvec2& highest) {
  const glm::dmat4 rows = glm::transpose(clip_from_world);
  Frustum result;
  result.add(rows[0] - lowest.x * rows[3]);
  result.add(highest.x * rows[3] - rows[0]);
  result.add(rows[1] - lowest.y * rows[3]);
  result.add(highest.y * rows[3] - rows[1]);
  result.add(rows[2] + rows[3]);
  return result;
}

Frustum frustum_around_pixel(const glm::dmat4& clip_from_world, const glm::dvec2& size_px, const glm::dvec2& pixel,
                             double radius_px) {
  const glm::dvec2 center(2.0 * pixel.x / size_px.x - 1.0, 1.0 - 2.0 * pixel.y / size_px.y);
  const glm::dvec2 reach = 2.0 * radius_px / size_px;
  return frustum_of_rectangle(clip_from_world, center - reach, center + reach);
}

}  // namespace ryosen
