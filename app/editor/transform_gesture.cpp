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

std::string letter_name(char letter) { return letter == 0 ? "" : std::string(1, ' ') + letter; }

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

void TransformGesture::follow_move(const Where& where) {
  const double depth = depth_of(where.camera, middle_);
  glm::dvec3 by =
      place_at(where.camera, where.view, where.pixel, depth) - place_at(where.camera, where.view, start_, depth);
  const double step = grid_step(units_per_pixel(where.camera, where.view, depth) * where.view.height);
  if (where.under) by = *where.under - middle_;
  if (axis_ && where.under) {
    by = glm::dot(by, *axis_) * *axis_;
  } else if (axis_) {
    const auto from = nearest_on_axis(middle_, *axis_, ray_through(where.camera, where.view, start_));
    const auto to = nearest_on_axis(middle_, *axis_, ray_through(where.camera, where.view, where.pixel));
    double along = from && to ? *to - *from : 0;
    if (where.snaps) along = to_step(along, step);
    by = along * *axis_;
  } else if (where.snaps && !where.under) {
    for (int k = 0; k < 3; ++k) by[k] = to_step(by[k], step);
  }
  if (is_finite(by)) transform_.by = by;
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
      transform_.by = *number * axis_.value_or(glm::dvec3(1, 0, 0));
      break;
    case PointTransform::Kind::turn:
      transform_.angle_deg = *number;
      break;
    case PointTransform::Kind::scale:
      transform_.factor = *number;
  }
}

void TransformGesture::choose_axis(const Mesh& mesh, char letter) {
  axis_letter_ = axis_letter_ == letter ? '\0' : letter;
  axis_.reset();
  if (axis_letter_ == 'X') axis_ = glm::dvec3(1, 0, 0);
  if (axis_letter_ == 'Y') axis_ = glm::dvec3(0, 1, 0);
  if (axis_letter_ == 'Z') axis_ = glm::dvec3(0, 0, 1);
  if (axis_letter_ == 'N') axis_ = direction_of(mean_normal(mesh, elements_, points_));
  if (!axis_) axis_letter_ = '\0';
  if (kind_ != PointTransform::Kind::move) transform_.axis = axis_;
}

bool TransformGesture::key(const Mesh& mesh, std::string_view chord) {
  if (chord.starts_with("Numpad")) chord.remove_prefix(std::string_view("Numpad").size());
  if (chord == "Backspace") {
    if (!typed_.empty()) typed_.pop_back();
  } else if (chord == "O") {
    falloff_ = falloff_ > 0 ? 0 : 0.1 * size_;
    find_moved(mesh);
  } else if (chord.size() == 1 && std::string_view("XYZN").find(chord[0]) != std::string_view::npos) {
    choose_axis(mesh, chord[0]);
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
  const std::string letter = letter_name(axis_letter_);
  switch (kind_) {
    case PointTransform::Kind::move: {
      const glm::dvec3& by = transform_.by;
      const std::string amount = axis_ ? short_text(glm::dot(by, *axis_))
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
