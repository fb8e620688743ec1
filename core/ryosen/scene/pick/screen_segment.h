// Projection of points and segments to the screen, prepared for many queries with one camera.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "ryosen/scene/view/camera.h"

namespace ryosen {

struct NearestOnScreen {
  double distance_px;  // from the given pixel
  double along;        // parameter of the point on the segment in space, 0 at its first end
  double depth;        // along the view direction
};

class ScreenProjection {
 public:
  ScreenProjection(const Camera& camera, Size view);

  // None if the point is not in front of the eye.
  std::optional<ScreenPoint> project(const glm::dvec3& place) const;
  // The point of the segment whose projection is nearest to a pixel; none if all of it is behind the eye.
  std::optional<NearestOnScreen> nearest_on_segment(const glm::dvec3& a, const glm::dvec3& b, glm::dvec2 pixel) const;
  // For frustum queries; the far plane is beyond everything relevant there.
  glm::dmat4 clip_from_mesh() const;

 private:
  Camera camera_;
  Size view_;
  CameraAxes axes_;
  double units_at_one_;  // height of the view at depth 1
};

}  // namespace ryosen
