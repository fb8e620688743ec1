#include "ryosen/scene/view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <vector>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Tangent of half the vertical opening angle.
double half_height(const Camera& camera) { return std::tan(glm::radians(camera.fov_y_deg) / 2); }

double target_depth(const Camera& camera) { return length_of(camera.target - camera.eye); }

glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& axis, double angle_rad) {
  return glm::dvec3(glm::rotate(glm::dmat4(1.0), angle_rad, axis) * glm::dvec4(vector, 0.0));
}

// The extent of points along the camera's axes, and the offsets of the bounding frustum's side planes: max of x - t z
// etc.
struct Extent {
  glm::dvec3 low{infinity};
  glm::dvec3 high{-infinity};
  double right = -infinity, left = -infinity, above = -infinity, below = -infinity;
};

// Of the side planes of a frustum: how far each leans outwards per unit of depth.
struct Slopes {
  double right, left, above, below;
};

// In units of 2^exponent, from an origin amid them.
Extent extent_of(std::span<const glm::dvec3> points, const CameraAxes& a, const glm::dvec3& origin, int exponent,
                 const Slopes& slopes) {
  Extent e;
  const bool is_usual = std::abs(exponent) < 1000;
  const double factor = is_usual ? std::ldexp(1.0, -exponent) : 1.0;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 p = is_usual ? (point - origin) * factor : times_power_of_two(point - origin, -exponent);
    const glm::dvec3 q(glm::dot(p, a.right), glm::dot(p, a.up), glm::dot(p, a.forward));
    if (!is_finite(q)) continue;
    e.low = glm::min(e.low, q);
    e.high = glm::max(e.high, q);
    e.right = std::max(e.right, q.x - slopes.right * q.z);
    e.left = std::max(e.left, -q.x - slopes.left * q.z);
    e.above = std::max(e.above, q.y - slopes.above * q.z);
    e.below = std::max(e.below, -q.y - slopes.below * q.z);
  }
  return e;
}

Extent of_both(const Extent& a, const Extent& b) {
  return {glm::min(a.low, b.low),   glm::max(a.high, b.high),   std::max(a.right, b.right),
          std::max(a.left, b.left), std::max(a.above, b.above), std::max(a.below, b.below)};
}

// The sum, in the sense of unite(), of what of() finds for parts of the points, on several threads.
template <class Found, class Of, class Unite>
Found of_parts(std::span<const glm::dvec3> points, const Of& of, const Unite& unite) {
  const unsigned parts = threads_for(points.size());
  std::vector<Found> found(parts);
  for_each_part(
      static_cast<std::uint32_t>(points.size()), parts,
      [&](unsigned t, std::uint32_t begin, std::uint32_t end) { found[t] = of(points.subspan(begin, end - begin)); });
  for (unsigned t = 1; t < parts; ++t) found[0] = unite(found[0], found[t]);
  return found[0];
}

// From the eye to the target, or half of it where that is more than the largest number.
glm::dvec3 way_to_target(const Camera& camera) {
  const glm::dvec3 way = camera.target - camera.eye;
  return is_finite(way) ? way : 0.5 * camera.target - 0.5 * camera.eye;
}

}  // namespace

Box bounds_of(std::span<const glm::dvec3> points) {
  const Box box = of_parts<Box>(points, box_of_finite, [](Box a, const Box& b) {
    a.add(b);
    return a;
  });
  return box.is_empty() ? Box{glm::dvec3(0), glm::dvec3(0)} : box;
}

CameraAxes axes(const Camera& camera) {
  CameraAxes a;
  a.forward = unit_vector(way_to_target(camera));
  a.right = glm::normalize(glm::cross(a.forward, unit_vector(camera.up)));
  a.up = glm::cross(a.right, a.forward);
  return a;
}

glm::dmat4 view_from_mesh(const Camera& camera) { return glm::lookAt(camera.eye, camera.target, camera.up); }

glm::dmat4 clip_from_view(const Camera& camera, double aspect, double near_distance, double far_distance) {
  glm::dmat4 clip(0.0);
  const double depth = far_distance - near_distance;
  if (camera.ortho_height) {
    clip[0][0] = 2 / (*camera.ortho_height * aspect);
    clip[1][1] = 2 / *camera.ortho_height;
    clip[2][2] = -2 / depth;
    clip[3][2] = -(far_distance + near_distance) / depth;
    clip[3][3] = 1;
  } else {
    clip[0][0] = 1 / (half_height(camera) * aspect);
    clip[1][1] = 1 / half_height(camera);
    clip[2][2] = -(far_distance + near_distance) / depth;
    clip[2][3] = -1;
    clip[3][2] = -2 * near_distance * (far_distance / depth);
  }
  return clip;
}

namespace {

// Where a point lies that is `offset` from the origin in units of 2^exponent. A point beyond the largest number comes
// back along `way`, which has length 1, as far as it must.
glm::dvec3 place(const glm::dvec3& origin, const glm::dvec3& offset, int exponent, const glm::dvec3& way) {
  const glm::dvec3 far_off = times_power_of_two(origin, -exponent) + offset;
  const double largest = std::ldexp(std::numeric_limits<double>::max() / 2, -exponent) * 2 * (1 - 1e-9);
  double back = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double beyond = std::abs(far_off[axis]) - largest;
    if (beyond > 0 && far_off[axis] * way[axis] < 0) back = std::max(back, beyond / std::abs(way[axis]));
  }
  return times_power_of_two(far_off + way * back, exponent);
}

// How much of each half of the view is free, behind the margin: of the whole it is as much on both sides.
Slopes free_halves(const CoveredShares& covered, double margin) {
  const double margin_x = 2 * margin * (1 - covered.left - covered.right), margin_y = 2 * margin * (1 - covered.above);
  return {1 - 2 * covered.right - margin_x, 1 - 2 * covered.left - margin_x, 1 - 2 * covered.above - margin_y,
          1 - margin_y};
}

}  // namespace

Camera fitted(const Camera& camera, std::span<const glm::dvec3> points, double aspect, double margin,
              const CoveredShares& covered) {
  Camera result = camera;
  const CameraAxes a = axes(camera);
  const Slopes free = free_halves(covered, margin);
  const double free_x = (free.right + free.left) / 2, free_y = (free.above + free.below) / 2, tan = half_height(camera);
  const Slopes slopes{tan * free.right * aspect, tan * free.left * aspect, tan * free.above, tan * free.below};
  const Box box = bounds_of(points);
  const glm::dvec3 origin = box.middle();
  const glm::dvec3 half_size = 0.5 * box.highest - 0.5 * box.lowest;
  const int exponent = largest_magnitude(half_size) > 0 ? exponent_of(half_size) : 0;
  const Extent e = of_parts<Extent>(
      points, [&](auto part) { return extent_of(part, a, origin, exponent, slopes); }, of_both);
  if (!(e.low.x <= e.high.x)) return result;
  const glm::dvec3 middle = 0.5 * (e.low + e.high);
  const glm::dvec3 size = e.high - e.low;
  const double widest = std::max({size.x / aspect, size.y, size.z * 1e-3});
  if (camera.ortho_height) {
    const double height =
        widest > 0 ? std::max({size.x / aspect / free_x, size.y / free_y, size.z * 1e-3 / std::min(free_x, free_y)})
                   : 1;
    const double radius = std::max(glm::length(size), height);
    // By how much of half the view what is free lies beside the middle.
    const double beside = (free.left - free.right) / 2 * aspect, below = (free.below - free.above) / 2;
    const glm::dvec3 target =
        a.right * (middle.x + beside * height / 2) + a.up * (middle.y + below * height / 2) + a.forward * middle.z;
    result.ortho_height = std::min(std::ldexp(height, exponent), std::numeric_limits<double>::max());
    result.target = place(origin, target, exponent, a.forward);
    result.eye = place(origin, target - a.forward * (2 * radius), exponent, a.forward);
    return result;
  }
  // The eye is at the depth where the left and right (or top and bottom) planes of the bounding frustum intersect.
  const double back =
      std::max((e.right + e.left) / (slopes.right + slopes.left), (e.above + e.below) / (slopes.above + slopes.below));
  // Keep some distance from the nearest point; a single position gets a view one unit high.
  const double nearest = e.low.z - (widest > 0 ? 0.1 * widest : 0.5 / half_height(camera));
  const double depth = widest > 0 ? std::min(-back, nearest) : nearest;
  // In the middle between where each pair of planes touches, at that depth.
  const double beside = depth * (slopes.right - slopes.left) / 2, below = depth * (slopes.above - slopes.below) / 2;
  const glm::dvec3 eye =
      a.right * ((e.right - e.left) / 2 + beside) + a.up * ((e.above - e.below) / 2 + below) + a.forward * depth;
  result.eye = place(origin, eye, exponent, a.forward);
  result.target = place(origin, eye + a.forward * (middle.z - depth), exponent, a.forward);
  return result;
}

Camera orbited(const Camera& camera, glm::dvec2 moved_px, Size view, const glm::dvec3& about) {
  const double quarter = glm::radians(90.0);
  const glm::dvec2 angle = moved_px * (quarter / (0.5 * view.height));
  const glm::dvec3 axis(0, 1, 0);
  const CameraAxes a = axes(camera);
  // Clamp the tilt at the poles: the up vector never points below the horizon.
  const double tilt_now = std::atan2(-a.forward.y, a.up.y);
  const double tilt = std::clamp(tilt_now + angle.y, -quarter, quarter) - tilt_now;
  const auto rotated = [&](const glm::dvec3& v) { return turned(turned(v, a.right, -tilt), axis, -angle.x); };
  const glm::dvec3 forward = rotated(a.forward), to_target = camera.target - about;
  const bool is_about_target = to_target == glm::dvec3(0);  // which then stays to the last bit
  Camera result = camera;
  result.target = is_about_target ? camera.target : about + rotated(to_target);
  result.eye = result.target - forward * target_depth(camera);
  result.up = rotated(a.up);
  return result;
}

Camera panned(const Camera& camera, glm::dvec2 moved_px, Size view, const glm::dvec3& grabbed) {
  const CameraAxes a = axes(camera);
  const glm::dvec3 shift =
      (a.up * moved_px.y - a.right * moved_px.x) * units_per_pixel(camera, view, depth_of(camera, grabbed));
  Camera result = camera;
  result.eye += shift;
  result.target += shift;
  return result;
}

Camera zoomed(const Camera& camera, double factor, const glm::dvec3& fixed) {
  Camera result = camera;
  result.target = fixed + (camera.target - fixed) / factor;
  if (camera.ortho_height) {
    result.ortho_height = *camera.ortho_height / factor;
    result.eye = result.target + (camera.eye - camera.target);
  } else {
    result.eye = fixed + (camera.eye - fixed) / factor;
  }
  return result;
}

Camera centred(const Camera& camera, const glm::dvec3& point) {
  const glm::dvec3 forward = axes(camera).forward, shift = point - camera.target;
  Camera result = camera;
  result.target = point;
  result.eye += shift - forward * glm::dot(shift, forward);
  return result;
}

Camera with_ortho(const Camera& camera, bool ortho) {
  Camera result = camera;
  if (ortho && !camera.ortho_height) result.ortho_height = 2 * half_height(camera) * target_depth(camera);
  if (!ortho && camera.ortho_height) {
    const glm::dvec3 forward = axes(camera).forward;
    result.eye = camera.target - forward * (*camera.ortho_height / (2 * half_height(camera)));
    result.ortho_height.reset();
  }
  return result;
}

std::optional<ScreenPoint> project(const Camera& camera, Size view, const glm::dvec3& point) {
  const CameraAxes a = axes(camera);
  const glm::dvec3 offset = point - camera.eye;
  const double depth = glm::dot(offset, a.forward);
  if (!camera.ortho_height && !(depth > 0)) return std::nullopt;
  const double scale = units_per_pixel(camera, view, depth);
  return ScreenPoint{
      {0.5 * view.width + glm::dot(offset, a.right) / scale, 0.5 * view.height - glm::dot(offset, a.up) / scale},
      depth};
}

double units_per_pixel(const Camera& camera, Size view, double depth) {
  if (camera.ortho_height) return *camera.ortho_height / view.height;
  return 2 * half_height(camera) * depth / view.height;
}

Ray ray_through(const Camera& camera, Size view, glm::dvec2 pixel) {
  const CameraAxes a = axes(camera);
  const glm::dvec2 off = pixel - 0.5 * glm::dvec2(view.width, view.height);
  const glm::dvec3 across = (a.right * off.x - a.up * off.y) * units_per_pixel(camera, view, 1);
  if (camera.ortho_height) return {camera.eye + across, a.forward};
  return {camera.eye, glm::normalize(a.forward + across)};
}

double depth_of(const Camera& camera, const glm::dvec3& point) {
  return glm::dot(point - camera.eye, axes(camera).forward);
}

glm::dvec3 place_at(const Camera& camera, Size view, glm::dvec2 pixel, double depth) {
  const Ray ray = ray_through(camera, view, pixel);
  return ray.origin + ray.direction * (depth / glm::dot(ray.direction, axes(camera).forward));
}

}  // namespace ryosen
