// Where places and segments appear on the screen, prepared for many questions with one camera.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/view/camera.h"

namespace ryosen {

struct NearestOnScreen {
  double distance_px;  // from the pixel asked about
  double along;        // of the place on the segment in space, 0 at its first end
  double depth;        // along the view direction
};

class ScreenProjection {
 public:
  ScreenProjection(const Camera& camera, Size view);

  // Nothing for a place that is not in front of the eye.
  std::optional<ScreenPoint> project(const glm::dvec3& place) const;
  // The place of the segment that appears nearest to a pixel; nothing when all of it lies behind the eye.
  std::optional<NearestOnScreen> nearest_on_segment(const glm::dvec3& a, const glm::dvec3& b, glm::dvec2 pixel) const;
  // For frusta; the far plane lies beyond everything that matters there.
  glm::dmat4 clip_from_mesh() const;

 private:
  Camera camera_;
  Size view_;
  CameraAxes axes_;
  double units_at_one_;  // height of the view at depth 1
};

}  // namespace ryosen
