#include "app/editor/transform_gesture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/analysis/neighbourhood.h"
#include "core/geometry/is_finite.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/find_element.h"
#include "core/ops/lines/arguments.h"
#include "core/ops/op.h"
#include "core/selection/slot_ranges.h"

namespace ryosen {

namespace {

// The parameter on the line p + t u nearest to a ray; none where they run alike.
std::optional<double> nearest_on_axis(const glm::dvec3& p, const glm::dvec3& u, const Ray& ray) {
  const glm::dvec3 w = p - ray.origin, d = unit_vector(ray.direction);
  const double b = glm::dot(u, d), rest = 1 - b * b;
  if (rest < 1e-6) return std::nullopt;
  return (b * glm::dot(d, w) - glm::dot(u, w)) / rest;
}

double to_step(double value, double step) { return std::round(value / step) * step; }

// A power of ten that is about a hundredth of a length.
double grid_step(double length) { return std::pow(10.0, std::floor(std::log10(length / 30))); }

// Of the faces among the elements; where there are none, of those at the points.
glm::dvec3 mean_normal(const Mesh& mesh, std::span<const Element> elements, std::span<const Vertex> points) {
  Neighbourhood around(mesh);
  glm::dvec3 sum(0);
  bool has_faces = false;
  for (const Element& e : elements) {
    if (e.kind != Element::Kind::face || !is_alive(mesh, e)) continue;
    sum += around.normal(e.face());
    has_faces = true;
  }
  if (has_faces) return sum;
  for (const Vertex v : points)
    for_each_copy(mesh, v, [&](Vertex copy) {
      for (const Face f : faces_around(mesh, copy))
        if (f) sum += around.normal(f);
    });
  return sum;
}

// " X", or the plane across it as " YZ".
std::string axis_name(char letter, bool in_plane) {
  if (letter == 0) return "";
  if (!in_plane) return std::string(1, ' ') + letter;
  return letter == 'X' ? " YZ" : letter == 'Y' ? " ZX" : letter == 'Z' ? " XY" : " ⊥N";
}

bool is_axis_key(std::string_view chord) {
  if (chord.starts_with("Shift+")) chord.remove_prefix(std::string_view("Shift+").size());
  return chord == "X" || chord == "Y" || chord == "Z" || chord == "N";
}

}  // namespace

TransformGesture::TransformGesture(PointTransform::Kind kind, const Mesh& mesh, Elements elements, glm::dvec2 pixel)
    : kind_(kind), elements_(std::move(elements)), points_(points_of(mesh, elements_)), start_(pixel) {
  const Box box = bounds_of(mesh.positions());
  size_ = std::max(length_of(box.highest - box.lowest), 1e-300);
  middle_ = middle_of(mesh, points_);
  transform_.kind = kind;
  transform_.about = middle_;
  find_moved(mesh);
}

void TransformGesture::find_moved(const Mesh& mesh) { moved_ = moved_points(mesh, points_, falloff_); }

void TransformGesture::follow(const Mesh&, const Where& where) {
  switch (kind_) {
    case PointTransform::Kind::move:
      follow_move(where);
      break;
    case PointTransform::Kind::turn:
      follow_turn(where);
      break;
    case PointTransform::Kind::scale:
      follow_scale(where);
  }
  last_ = where.pixel;
  take_number();
}

// Where the rays of both pixels meet the plane; along it by as much as the view moves where it is seen from the side.
glm::dvec3 TransformGesture::moved_in_plane(const Where& where) const {
  const auto met = [&](glm::dvec2 pixel) -> std::optional<glm::dvec3> {
    const Ray ray = ray_through(where.camera, where.view, pixel);
    const glm::dvec3 direction = unit_vector(ray.direction);
    const double towards = glm::dot(direction, *axis_);
    constexpr double least = 0.02;
    if (std::abs(towards) < least) return std::nullopt;
    const double far = glm::dot(middle_ - ray.origin, *axis_) / towards;
    if (far <= 0 && !where.camera.ortho_height) return std::nullopt;  // above the horizon
    return ray.origin + far * direction;
  };
  const auto from = met(start_), to = met(where.pixel);
  if (from && to) return *to - *from;
  const double depth = depth_of(where.camera, middle_);
  return place_at(where.camera, where.view, where.pixel, depth) - place_at(where.camera, where.view, start_, depth);
}

// Along the axis or in the plane that was chosen, or across the view.
glm::dvec3 TransformGesture::moved_by(const Where& where, double step) const {
  const auto stepped = [&](glm::dvec3 by) {
    for (int k = 0; k < 3 && where.snaps && !where.under; ++k) by[k] = to_step(by[k], step);
    return by;
  };
  const auto in_plane = [&](const glm::dvec3& by) { return by - glm::dot(by, *axis_) * *axis_; };
  if (where.under) {
    const glm::dvec3 by = *where.under - middle_;
    return !axis_ ? by : is_in_plane_ ? in_plane(by) : glm::dot(by, *axis_) * *axis_;
  }
  if (is_in_plane_) return in_plane(stepped(in_plane(moved_in_plane(where))));
  if (axis_) {
    const auto from = nearest_on_axis(middle_, *axis_, ray_through(where.camera, where.view, start_));
    const auto to = nearest_on_axis(middle_, *axis_, ray_through(where.camera, where.view, where.pixel));
    const double along = from && to ? *to - *from : 0;
    return (where.snaps ? to_step(along, step) : along) * *axis_;
  }
  const double depth = depth_of(where.camera, middle_);
  return stepped(place_at(where.camera, where.view, where.pixel, depth) -
                 place_at(where.camera, where.view, start_, depth));
}

void TransformGesture::follow_move(const Where& where) {
  const double unit = units_per_pixel(where.camera, where.view, depth_of(where.camera, middle_));
  const glm::dvec3 by = moved_by(where, grid_step(unit * where.view.height));
  if (is_finite(by)) transform_.by = by;
  snapped_to_ = where.under;
}

void TransformGesture::follow_turn(const Where& where) {
  const auto centre = project(where.camera, where.view, middle_);
  const glm::dvec3 forward = axes(where.camera).forward;
  transform_.axis = axis_ ? *axis_ : -forward;
  if (!centre) return;
  const glm::dvec2 a = last_.value_or(start_) - centre->pixel, b = where.pixel - centre->pixel;
  if (glm::length(a) < 1e-9 || glm::length(b) < 1e-9) return;
  // Pixels go down, so that this is clockwise; positive is counter-clockwise as it is seen.
  const double clockwise = std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)) * 180 / std::numbers::pi;
  const bool seen_from_behind = axis_ && glm::dot(*axis_, forward) > 0;
  turned_deg_ += seen_from_behind ? clockwise : -clockwise;
  transform_.angle_deg = where.snaps ? to_step(turned_deg_, 5) : turned_deg_;
}

void TransformGesture::follow_scale(const Where& where) {
  transform_.axis = axis_;
  const auto centre = project(where.camera, where.view, middle_);
  if (!centre) return;
  const glm::dvec2 a = start_ - centre->pixel, b = where.pixel - centre->pixel;
  constexpr double least_px = 8;  // nearer to the middle a pixel would be too much
  const double from = std::max(glm::length(a), least_px);
  const double factor = (glm::dot(a, b) < 0 ? -1 : 1) * glm::length(b) / from;
  transform_.factor = where.snaps ? to_step(factor, 0.1) : factor;
}

void TransformGesture::take_number() {
  const auto number = parse_double(typed_);
  if (!number) return;
  switch (kind_) {
    case PointTransform::Kind::move:
      transform_.by = *number * typed_direction();
      break;
    case PointTransform::Kind::turn:
      transform_.angle_deg = *number;
      break;
    case PointTransform::Kind::scale:
      transform_.factor = *number;
  }
}

// Along which a typed number moves: in a plane its first axis, X, Y or Z.
glm::dvec3 TransformGesture::typed_direction() const {
  if (!axis_) return {1, 0, 0};
  if (!is_in_plane_) return *axis_;
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0);
  const glm::dvec3 first = std::abs(axis_->x) < 0.9 ? x : y;
  return unit_vector(first - glm::dot(first, *axis_) * *axis_);
}

void TransformGesture::choose_axis(const Mesh& mesh, char letter, bool in_plane) {
  axis_letter_ = axis_letter_ == letter && is_in_plane_ == in_plane ? '\0' : letter;
  is_in_plane_ = in_plane;
  axis_.reset();
  if (axis_letter_ == 'X') axis_ = glm::dvec3(1, 0, 0);
  if (axis_letter_ == 'Y') axis_ = glm::dvec3(0, 1, 0);
  if (axis_letter_ == 'Z') axis_ = glm::dvec3(0, 0, 1);
  if (axis_letter_ == 'N') axis_ = direction_of(mean_normal(mesh, elements_, points_));
  if (!axis_) axis_letter_ = '\0';
  is_in_plane_ = is_in_plane_ && axis_;
  if (kind_ != PointTransform::Kind::move) transform_.axis = axis_;
}

bool TransformGesture::key(const Mesh& mesh, std::string_view chord) {
  if (chord.starts_with("Numpad")) chord.remove_prefix(std::string_view("Numpad").size());
  if (chord == "Backspace") {
    if (!typed_.empty()) typed_.pop_back();
  } else if (chord == "O") {
    falloff_ = falloff_ > 0 ? 0 : 0.1 * size_;
    find_moved(mesh);
  } else if (is_axis_key(chord)) {
    choose_axis(mesh, chord.back(), chord.size() > 1 && kind_ == PointTransform::Kind::move);
  } else if (chord == "-") {
    typed_ = typed_.starts_with('-') ? typed_.substr(1) : "-" + typed_;
  } else if (chord.size() == 1 && std::string_view("0123456789.").find(chord[0]) != std::string_view::npos) {
    if (chord != "." || typed_.find('.') == std::string::npos) typed_ += chord;
  } else {
    return false;
  }
  take_number();
  return true;
}

bool TransformGesture::widen(const Mesh& mesh, double steps) {
  if (!(falloff_ > 0)) return false;
  falloff_ = std::clamp(falloff_ * std::pow(1.1, steps), 1e-6 * size_, 10 * size_);
  find_moved(mesh);
  return true;
}

bool TransformGesture::does_nothing() const {
  switch (kind_) {
    case PointTransform::Kind::move:
      return transform_.by == glm::dvec3(0);
    case PointTransform::Kind::turn:
      return transform_.angle_deg == 0;
    case PointTransform::Kind::scale:
      return transform_.factor == 1;
  }
  return true;
}

std::optional<glm::dvec3> TransformGesture::movement() const {
  if (kind_ != PointTransform::Kind::move || falloff_ > 0) return std::nullopt;
  return transform_.by;
}

std::string TransformGesture::line(const Mesh&) const {
  std::string line;
  const auto axis = [&] { return transform_.axis ? " axis=" + format_place(*transform_.axis) : std::string(); };
  switch (kind_) {
    case PointTransform::Kind::move:
      line = "translate by=" + format_place(transform_.by);
      break;
    case PointTransform::Kind::turn:
      line = "rotate angle=" + format_double(transform_.angle_deg) + axis() + " about=" + format_place(middle_);
      break;
    case PointTransform::Kind::scale:
      line = "scale factor=" + format_double(transform_.factor) + axis() + " about=" + format_place(middle_);
  }
  if (falloff_ > 0) line += " falloff=" + format_double(falloff_);
  const Elements points(points_.begin(), points_.end());
  std::string names = slot_ranges(points).substr(1);
  std::replace(names.begin(), names.end(), ' ', ',');
  return line + " elements=" + names;
}

Text TransformGesture::told() const {
  const auto short_text = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return std::string(text);
  };
  Text text;
  const std::string letter = axis_name(axis_letter_, is_in_plane_);
  switch (kind_) {
    case PointTransform::Kind::move: {
      const glm::dvec3& by = transform_.by;
      const std::string amount = axis_ && !is_in_plane_
                                     ? short_text(glm::dot(by, *axis_))
                                     : short_text(by.x) + ", " + short_text(by.y) + ", " + short_text(by.z);
      text = {"Move" + letter + " " + amount, "移動" + letter + " " + amount};
      break;
    }
    case PointTransform::Kind::turn: {
      const std::string amount = short_text(transform_.angle_deg);
      text = {"Turn" + letter + " " + amount + " degrees", "回転" + letter + " " + amount + " 度"};
      break;
    }
    case PointTransform::Kind::scale: {
      const std::string amount = short_text(transform_.factor);
      text = {"Scale" + letter + " " + amount, "拡大縮小" + letter + " " + amount};
    }
  }
  if (!typed_.empty()) text = text + Text{" [" + typed_ + "]", " [" + typed_ + "]"};
  if (falloff_ > 0) text = text + Text{", falloff " + short_text(falloff_), "、減衰半径 " + short_text(falloff_)};
  return text;
}

}  // namespace ryosen
