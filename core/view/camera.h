// Cameras: where the eye is, what a pixel sees, and how the mouse moves it. All lengths in the units of the mesh, all
// pixels from the upper left corner of the view (the centre of the first pixel is 0.5, 0.5).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "core/pick/ray.h"
#include "core/view/size.h"

namespace ryosen {

struct Bounds {
  glm::dvec3 min{0};
  glm::dvec3 max{0};

  glm::dvec3 centre() const { return 0.5 * min + 0.5 * max; }
};

// Length, and the vector of length 1 in the same direction, also where their squares are too large or too small a number.
double length_of(const glm::dvec3& vector);
glm::dvec3 unit_vector(const glm::dvec3& vector);

// The box around finite points; a box at the origin when there is none.
Bounds bounds_of(std::span<const glm::dvec3> points);

// Perspective, or orthographic when ortho_height is set. eye != target, up not parallel to target - eye.
struct Camera {
  glm::dvec3 eye{0, 0, 1};
  glm::dvec3 target{0, 0, 0};
  glm::dvec3 up{0, 1, 0};
  double fov_y_deg = 35;
  std::optional<double> ortho_height;  // what the height of the view shows, in mesh units
};

// The axes of a camera in the mesh's space: right, up and forward are orthogonal and of length 1.
struct CameraAxes {
  glm::dvec3 right, up, forward;
};
CameraAxes axes(const Camera& camera);

// Takes mesh space to view space (x right, y up, looking along -z).
glm::dmat4 view_from_mesh(const Camera& camera);
// Takes view space to clip space; near_distance < far_distance along the view direction, near > 0 in perspective.
glm::dmat4 clip_from_view(const Camera& camera, double aspect, double near_distance, double far_distance);

enum class NamedView { front, back, left, right, top, bottom, iso };
std::optional<NamedView> named_view_of(std::string_view name);

// `margin` is the share of the view's width and height left free on each side.
inline constexpr double default_margin = 0.06;

// The camera with the same direction that shows all points, centred, as large as the margin allows. The target comes to
// lie in the depth of the middle of their box. Points at a single place are shown with a view one unit high. Where the
// eye would lie beyond the largest number it comes as far as it can. Linear.
Camera fitted(const Camera& camera, std::span<const glm::dvec3> points, double aspect, double margin = default_margin);
Camera fitted(const Camera& camera, const Bounds& box, double aspect, double margin = default_margin);
// front looks along -Z with +Y up, right along -X, top along -Y with -Z up, iso along (-1,-1,-1); fitted.
Camera named_view(NamedView view, std::span<const glm::dvec3> points, double aspect);

// Turns around the target as on a turntable whose axis is Y, and tilts up to the poles. Half the height of the view is
// a quarter turn.
Camera orbited(const Camera& camera, glm::dvec2 moved_px, Size view);
// Moves so that what lies in the depth of the target follows the pointer.
Camera panned(const Camera& camera, glm::dvec2 moved_px, Size view);
// Shows things `factor` times as large; what the pointer shows in the depth of the target stays under it.
Camera zoomed(const Camera& camera, double factor, glm::dvec2 pointer_px, Size view);
// Between perspective and orthographic, with the target shown equally large.
Camera with_ortho(const Camera& camera, bool ortho);

// Where a point appears. depth is the distance along the view direction, in perspective > 0.
struct ScreenPoint {
  glm::dvec2 pixel;
  double depth;
};
// Nothing when the point is not in front of the eye (perspective only).
std::optional<ScreenPoint> project(const Camera& camera, Size view, const glm::dvec3& point);

// How many mesh units one pixel shows at a depth.
double units_per_pixel(const Camera& camera, Size view, double depth);

// The ray of the mesh points that appear at a pixel, from the eye; in orthographic from the plane of the eye.
Ray ray_through(const Camera& camera, Size view, glm::dvec2 pixel);

}  // namespace ryosen
