#include "ryosen/scene/pick/screen_segment.h"
#include "ryosen/geometry/unit_vector.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ryosen {

ScreenProjection::ScreenProjection(const Camera& camera, Size view)
    : camera_(camera), view_(view), axes_(axes(camera)), units_at_one_(units_per_pixel(camera, {1, 1}, 1)) {}

// As the free function project(), with the camera axes precomputed.
std::optional<ScreenPoint> ScreenProjection::project(const glm::dvec3& place) const {
  const glm::dvec3 offset = place - camera_.eye;
  const double depth = glm::dot(offset, axes_.forward);
  if (!camera_.ortho_height && !(depth > 0)) return std::nullopt;
  const double scale = (camera_.ortho_height ? units_at_one_ : units_at_one_ * depth) / view_.height;
  return ScreenPoint{{0.5 * view_.width + glm::dot(offset, axes_.right) / scale,
                      0.5 * view_.height - glm::dot(offset, axes_.up) / scale},
                     depth};
}

std::optional<NearestOnScreen> ScreenProjection::nearest_on_segment(const glm::dvec3& a, const glm::dvec3& b,
                                                                    glm::dvec2 pixel) const {
  double from = 0, to = 1;
  if (!camera_.ortho_height) {
    // Clip to the part in front of the eye.
    const double depth_a = glm::dot(a - camera_.eye, axes_.forward), depth_b = glm::dot(b - camera_.eye, axes_.forward);
    const double least = 1e-6 * length_of(camera_.target - camera_.eye);
    if (depth_a < least && depth_b < least) return std::nullopt;
    if (depth_a < least) from = (least - depth_a) / (depth_b - depth_a);
    if (depth_b < least) to = (least - depth_a) / (depth_b - depth_a);
  }
  const auto p = project(a + from * (b - a)), q = project(a + to * (b - a));
  if (!p || !q) return std::nullopt;
  const glm::dvec2 direction = q->pixel - p->pixel;
  const double length2 = glm::dot(direction, direction);
  const double s = length2 > 0 ? std::clamp(glm::dot(pixel - p->pixel, direction) / length2, 0.0, 1.0) : 0.0;
  NearestOnScreen nearest{glm::length(p->pixel + s * direction - pixel), 0, 0};
  // Perspective-correct interpolation.
  const double t = camera_.ortho_height ? s : s * p->depth / ((1 - s) * q->depth + s * p->depth);
  nearest.along = from + t * (to - from);
  nearest.depth = p->depth + t * (q->depth - p->depth);
  return nearest;
}

glm::dmat4 ScreenProjection::clip_from_mesh() const {
  const double distance = length_of(camera_.target - camera_.eye);
  const double aspect = static_cast<double>(view_.width) / view_.height;
  return clip_from_view(camera_, aspect, 1e-6 * distance, 1e6 * distance) * view_from_mesh(camera_);
}

}  // namespace ryosen
