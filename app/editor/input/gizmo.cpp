#include "app/editor/input/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

// In pixels at display scale 1.
constexpr double shaft_begins = 20, shaft = 84, letter_at = 97, letter_size = 4.5;
constexpr double plate_begins = 30, plate_ends = 48;
constexpr double ring = 10, arc = 74, outer_arc = 92, knob = 5;
constexpr double reach = 7, least_shaft = 20;
constexpr double least_face_on = 0.25;  // of a plate: the cosine between its normal and the line of sight

constexpr HandleRow handle_rows[] = {
    {GizmoKind::move, HandleWay::free, "gesture move", "move across the view", "画面に沿って移動"},
    {GizmoKind::move, HandleWay::x, "gesture move x", "move along X", "X 方向に移動"},
    {GizmoKind::move, HandleWay::y, "gesture move y", "move along Y", "Y 方向に移動"},
    {GizmoKind::move, HandleWay::z, "gesture move z", "move along Z", "Z 方向に移動"},
    {GizmoKind::move, HandleWay::yz, "gesture move yz", "move in the plane YZ", "YZ 平面内で移動"},
    {GizmoKind::move, HandleWay::zx, "gesture move zx", "move in the plane ZX", "ZX 平面内で移動"},
    {GizmoKind::move, HandleWay::xy, "gesture move xy", "move in the plane XY", "XY 平面内で移動"},
    {GizmoKind::turn, HandleWay::x, "gesture turn x", "turn about X", "X 軸まわりに回転"},
    {GizmoKind::turn, HandleWay::y, "gesture turn y", "turn about Y", "Y 軸まわりに回転"},
    {GizmoKind::turn, HandleWay::z, "gesture turn z", "turn about Z", "Z 軸まわりに回転"},
    {GizmoKind::turn, HandleWay::free, "gesture turn", "turn in the view", "画面内で回転"},
    {GizmoKind::scale, HandleWay::free, "gesture scale", "scale all ways", "全方向に拡大縮小"},
    {GizmoKind::scale, HandleWay::x, "gesture scale x", "scale along X", "X 方向に拡大縮小"},
    {GizmoKind::scale, HandleWay::y, "gesture scale y", "scale along Y", "Y 方向に拡大縮小"},
    {GizmoKind::scale, HandleWay::z, "gesture scale z", "scale along Z", "Z 方向に拡大縮小"},
};

glm::dvec3 axis_vector(int axis) {
  glm::dvec3 vector(0);
  vector[axis] = 1;
  return vector;
}

// Makes the strokes of handles, in units of a pixel at display scale 1 where the middle is.
class Maker {
 public:
  Maker(const Camera& camera, Size view, const glm::dvec3& middle, double scale)
      : axes_(axes(camera)), camera_(camera), view_(view), middle_(middle), scale_(scale) {
    pixel_ = scale * units_per_pixel(camera, view, depth_of(camera, middle));
    to_eye_ = camera.ortho_height ? -axes_.forward : unit_vector(camera.eye - middle);
  }

  // Draws nothing where the handle is not to be seen or taken.
  GizmoHandle handle(const HandleRow& row) const {
    GizmoHandle made{&row, {}, {}, {}};
    if (const auto plane = plane_of(row.way))
      add_plate(made, *plane);
    else if (row.kind == GizmoKind::turn)
      add_arc(made);
    else if (const auto axis = axis_of(row.way))
      add_shaft(made, *axis);
    else
      add_circle(made.strokes, axes_.right, axes_.up, ring);
    return made;
  }

 private:
  glm::dvec3 at(const glm::dvec3& direction, double pixels) const { return middle_ + direction * (pixels * pixel_); }
  glm::dvec3 across(const glm::dvec3& from, double right, double up) const {
    return from + (right * axes_.right + up * axes_.up) * pixel_;
  }

  void add_shaft(GizmoHandle& to, int axis) const {
    const glm::dvec3 direction = axis_vector(axis);
    const glm::dvec3 tip = at(direction, shaft);
    const auto a = project(camera_, view_, middle_), b = project(camera_, view_, tip);
    if (!a || !b || glm::length(a->pixel - b->pixel) < least_shaft * scale_) return;
    const bool is_arrow = to.row->kind == GizmoKind::move;
    to.strokes.push_back({at(direction, shaft_begins), tip, is_arrow});
    if (!is_arrow) add_knob(to, tip);
    add_letter(to, axis, at(direction, letter_at));
  }

  void add_knob(GizmoHandle& to, const glm::dvec3& tip) const {
    const std::array corners{across(tip, -knob, -knob), across(tip, knob, -knob), across(tip, knob, knob),
                             across(tip, -knob, knob)};
    to.plate.assign(corners.begin(), corners.end());
    for (std::size_t i = 0; i < corners.size(); ++i) to.strokes.push_back({corners[i], corners[(i + 1) % 4]});
  }

  void add_plate(GizmoHandle& to, std::array<int, 2> plane) const {
    const glm::dvec3 u = axis_vector(plane[0]), v = axis_vector(plane[1]);
    if (std::abs(glm::dot(glm::cross(u, v), to_eye_)) < least_face_on) return;
    const auto corner = [&](double along_u, double along_v) { return middle_ + (along_u * u + along_v * v) * pixel_; };
    to.plate = {corner(plate_begins, plate_begins), corner(plate_ends, plate_begins), corner(plate_ends, plate_ends),
                corner(plate_begins, plate_ends)};
    for (std::size_t i = 0; i < to.plate.size(); ++i)
      to.strokes.push_back({to.plate[i], to.plate[(i + 1) % to.plate.size()]});
  }

  // The half of the circle about an axis that is nearer to the eye; about the line of sight all of it.
  void add_arc(GizmoHandle& to) const {
    const auto axis = axis_of(to.row->way);
    if (!axis) return add_circle(to.strokes, axes_.right, axes_.up, outer_arc);
    glm::dvec3 u = axis_vector((*axis + 1) % 3), v = axis_vector((*axis + 2) % 3);
    std::vector<GizmoStroke> circle;
    add_circle(circle, u, v, arc);
    const double least = -0.1 * arc * pixel_;
    for (const GizmoStroke& stroke : circle)
      if (glm::dot((stroke.a + stroke.b) * 0.5 - middle_, to_eye_) > least) to.strokes.push_back(stroke);
    // Between the two axes, so that no two letters fall together when the view is along one.
    if (glm::dot(u, to_eye_) < 0) u = -u;
    if (glm::dot(v, to_eye_) < 0) v = -v;
    add_letter(to, *axis, middle_ + unit_vector(u + v) * ((arc + letter_at - shaft) * pixel_));
  }

  void add_circle(std::vector<GizmoStroke>& to, const glm::dvec3& u, const glm::dvec3& v, double radius) const {
    const int sides = radius > 2 * ring ? 48 : 20;
    const auto corner = [&](int i) {
      const double angle = 2 * std::numbers::pi * (i % sides) / sides;
      return middle_ + (std::cos(angle) * u + std::sin(angle) * v) * (radius * pixel_);
    };
    for (int i = 0; i < sides; ++i) to.push_back({corner(i), corner(i + 1)});
  }

  void add_letter(GizmoHandle& to, int axis, const glm::dvec3& at_place) const {
    for (const LetterStroke& stroke : axis_letter(axis)) {
      const glm::dvec2 a = stroke.a * letter_size, b = stroke.b * letter_size;
      to.letter.push_back({across(at_place, a.x, a.y), across(at_place, b.x, b.y)});
    }
  }

  CameraAxes axes_;
  const Camera& camera_;
  Size view_;
  glm::dvec3 middle_, to_eye_;
  double scale_, pixel_;
};

double distance_to(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double squared = glm::dot(along, along);
  const double share = squared > 0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return glm::length(p - a - share * along);
}

// The corners go round in either sense.
bool is_inside(glm::dvec2 p, std::span<const glm::dvec2> corners) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = corners[i] - p, b = corners[(i + 1) % corners.size()] - p;
    (a.x * b.y - a.y * b.x < 0 ? left : right)++;
  }
  return !corners.empty() && (left == 0 || right == 0);
}

// In pixels; 0 on a plate and within the ring at the middle.
double distance_to(const GizmoHandle& handle, const Gizmo& gizmo, const Camera& camera, Size view, glm::dvec2 pixel,
                   double scale) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const GizmoStroke& stroke : handle.strokes) {
    const auto a = project(camera, view, stroke.a), b = project(camera, view, stroke.b);
    if (a && b) nearest = std::min(nearest, distance_to(pixel, a->pixel, b->pixel));
  }
  std::vector<glm::dvec2> corners;
  for (const glm::dvec3& corner : handle.plate)
    if (const auto seen = project(camera, view, corner)) corners.push_back(seen->pixel);
  if (is_inside(pixel, corners)) return 0;
  const bool is_ring = handle.row->way == HandleWay::free && handle.row->kind != GizmoKind::turn;
  if (const auto middle = project(camera, view, gizmo.middle); is_ring && middle)
    if (glm::length(pixel - middle->pixel) < ring * scale) return 0;
  return nearest;
}

}  // namespace

Gizmo gizmo_at(GizmoKind kind, const Camera& camera, Size view, const glm::dvec3& middle, double scale) {
  Gizmo gizmo{middle, {}};
  if (!project(camera, view, middle)) return gizmo;
  const Maker maker(camera, view, middle, scale);
  for (const HandleRow& row : handle_rows) {
    if (row.kind != kind) continue;
    GizmoHandle handle = maker.handle(row);
    if (!handle.strokes.empty()) gizmo.handles.push_back(std::move(handle));
  }
  return gizmo;
}

const GizmoHandle* handle_at(const Gizmo& gizmo, const Camera& camera, Size view, glm::dvec2 pixel, double scale) {
  const GizmoHandle* found = nullptr;
  double nearest = reach * scale;
  for (const GizmoHandle& handle : gizmo.handles) {
    const double distance = distance_to(handle, gizmo, camera, view, pixel, scale);
    if (distance >= nearest) continue;
    nearest = distance;
    found = &handle;
  }
  return found;
}

std::optional<int> axis_of(HandleWay way) {
  if (way > HandleWay::z) return std::nullopt;
  return static_cast<int>(way);
}

std::optional<std::array<int, 2>> plane_of(HandleWay way) {
  if (way == HandleWay::yz) return std::array{1, 2};
  if (way == HandleWay::zx) return std::array{2, 0};
  if (way == HandleWay::xy) return std::array{0, 1};
  return std::nullopt;
}

const std::vector<LetterStroke>& axis_letter(int axis) {
  static const std::array<std::vector<LetterStroke>, 3> letters{{
      {{{-0.8, -1}, {0.8, 1}}, {{-0.8, 1}, {0.8, -1}}},
      {{{-0.8, 1}, {0, 0}}, {{0.8, 1}, {0, 0}}, {{0, 0}, {0, -1}}},
      {{{-0.8, 1}, {0.8, 1}}, {{0.8, 1}, {-0.8, -1}}, {{-0.8, -1}, {0.8, -1}}},
  }};
  return letters[static_cast<std::size_t>(axis)];
}

}  // namespace ryosen
