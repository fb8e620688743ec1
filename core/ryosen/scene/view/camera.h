// Cameras: projection, rays through pixels, fitting, and orbit, pan and zoom. All lengths in the units of the mesh, all
// pixels from the upper left corner of the view (the centre of the first pixel is 0.5, 0.5).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "ryosen/geometry/box.h"
#include "ryosen/geometry/ray.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

// The axis-aligned bounding box of the finite points; a degenerate box at the origin if there are none.
Box bounds_of(std::span<const glm::dvec3> points);

// Perspective, or orthographic when ortho_height is set. eye != target, up not parallel to target - eye.
struct Camera {
  glm::dvec3 eye{0, 0, 1};
  glm::dvec3 target{0, 0, 0};
  glm::dvec3 up{0, 1, 0};
  double fov_y_deg = 35;
  std::optional<double> ortho_height;  // height of the view in mesh units

  friend bool operator==(const Camera&, const Camera&) = default;
};

// The axes of a camera in mesh space; right, up and forward are orthonormal.
struct CameraAxes {
  glm::dvec3 right, up, forward;
};
CameraAxes axes(const Camera& camera);

// Takes mesh space to view space (x right, y up, looking along -z).
glm::dmat4 view_from_mesh(const Camera& camera);
// Takes view space to clip space; near_distance < far_distance along the view direction, near > 0 in perspective.
glm::dmat4 clip_from_view(const Camera& camera, double aspect, double near_distance, double far_distance);

// `margin` is the share of the view's width and height left free on each side.
inline constexpr double default_margin = 0.06;

// The shares of the width of a view at its left and its right, and of its height at its top, in which nothing is seen.
struct CoveredShares {
  double left = 0, right = 0, above = 0;
};

// The camera with the same direction that shows all points, centred in what is not covered, as large as the margin
// allows, which is a share of that. The target is at the depth of the centre of their bounding box, in the middle of
// the view. If all points coincide the view is one unit high. An eye position that would overflow is clamped. O(n).
Camera fitted(const Camera& camera, std::span<const glm::dvec3> points, double aspect, double margin = default_margin,
              const CoveredShares& covered = {});

// Turntable rotation about a point, which stays where it is in the view: azimuth about Y, elevation clamped at the
// poles. Dragging half the view height turns 90 degrees.
Camera orbited(const Camera& camera, glm::dvec2 moved_px, Size view, const glm::dvec3& about);
// Pans so that what is as deep in the view as `grabbed` follows the pointer.
Camera panned(const Camera& camera, glm::dvec2 moved_px, Size view, const glm::dvec3& grabbed);
// Magnifies what is at `fixed` by `factor`: the eye goes towards it by a share of its distance, so never through it,
// and it stays where it is in the view.
Camera zoomed(const Camera& camera, double factor, const glm::dvec3& fixed);
// Puts a point into the middle of the view and makes it the target; the eye moves parallel to the view.
Camera centred(const Camera& camera, const glm::dvec3& point);
// Switches between perspective and orthographic, keeping the scale at the target.
Camera with_ortho(const Camera& camera, bool ortho);

// The projection of a point. depth is the distance along the view direction, > 0 in perspective.
struct ScreenPoint {
  glm::dvec2 pixel;
  double depth;
};
// Nothing when the point is not in front of the eye (perspective only).
std::optional<ScreenPoint> project(const Camera& camera, Size view, const glm::dvec3& point);

// The size of a pixel in mesh units at a depth.
double units_per_pixel(const Camera& camera, Size view, double depth);

// The ray through a pixel, in mesh space, from the eye; in orthographic from the plane of the eye.
Ray ray_through(const Camera& camera, Size view, glm::dvec2 pixel);

// How deep in the view a point lies: its distance from the plane of the eye.
double depth_of(const Camera& camera, const glm::dvec3& point);
// The point at a pixel that lies so deep.
glm::dvec3 place_at(const Camera& camera, Size view, glm::dvec2 pixel, double depth);

}  // namespace ryosen
