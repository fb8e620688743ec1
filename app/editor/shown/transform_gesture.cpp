#include "app/editor/shown/transform_gesture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "app/editor/commands/text/words.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/number_text.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

// The parameter on the line p + t u nearest to a ray; none where they run alike.
std::optional<double> nearest_on_axis(const glm::dvec3& p, const glm::dvec3& u, const Ray& ray) {
  const glm::dvec3 w = p - ray.origin, d = unit_vector(ray.direction);
  const double b = glm::dot(u, d), rest = 1 - b * b;
  if (rest < 1e-6) return std::nullopt;
  return (b * glm::dot(d, w) - glm::dot(u, w)) / rest;
}

// What added to a place gives the other, exactly where there is such a number: the difference is mostly off by no more
// than its last digit.
double way_from(double from, double to) {
  double by = to - from;
  for (int tries = 0; tries < 4 && from + by != to; ++tries)
    by = std::nextafter(
        by, from + by < to ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity());
  return from + by == to ? by : to - from;
}
glm::dvec3 way_from(const glm::dvec3& from, const glm::dvec3& to) {
  return {way_from(from.x, to.x), way_from(from.y, to.y), way_from(from.z, to.z)};
}

// The steps of the ground, or tenths of them where they would be longer than the hand goes, or tenfold where they would
// be too short to be felt; with a tenth asked for, that.
RoundStep felt_step(const TransformGesture::Where& where, double units_per_pixel) {
  constexpr double longest_px = 120, shortest_px = 6;
  RoundStep step = where.step;
  const auto length_px = [&] { return step.size() / (units_per_pixel * where.size_scale); };
  while (length_px() > longest_px && step.power > -300) --step.power;
  while (length_px() < shortest_px && step.power < 300) ++step.power;
  return where.is_fine ? step.tenth() : step;
}

constexpr RoundStep turn_step{5, 0}, scale_step{1, -1};
double stepped(double value, RoundStep step, const TransformGesture::Where& where) {
  return where.snaps ? (where.is_fine ? step.tenth() : step).nearest_to(value) : value;
}

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
  for (const Vertex v : points) for_each_face_at(mesh, v, [&](Face f) { sum += around.normal(f); });
  return sum;
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
  if (kind_ == PointTransform::Kind::move) follow_move(where);
  if (kind_ == PointTransform::Kind::turn) follow_turn(where);
  if (kind_ == PointTransform::Kind::scale) follow_scale(where);
  last_ = where.pixel;
  take_number();
}

void TransformGesture::hold(const Mesh& mesh, Vertex point) {
  held_ = mesh.position(point);
  held_name_ = name_to_select(mesh, point);
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

// Onto it where nothing binds it, else level with it.
glm::dvec3 TransformGesture::moved_onto(const glm::dvec3& target) const {
  const glm::dvec3 from = held_.value_or(middle_), by = way_from(from, target);
  if (!axis_) return by;
  const glm::dvec3 own = glm::abs(*axis_);
  const bool is_coordinate = std::max({own.x, own.y, own.z}) == 1;  // which stays exact
  const glm::dvec3 along = is_coordinate ? by * own : glm::dot(by, *axis_) * *axis_;
  return is_in_plane_ ? by - along : along;
}

// Along the axis or in the plane that was chosen, or across the view.
glm::dvec3 TransformGesture::moved_by(const Where& where, const std::optional<RoundStep>& step) const {
  const auto stepped = [&](glm::dvec3 by) {
    for (int k = 0; k < 3 && step; ++k) by[k] = step->nearest_to(by[k]);
    return by;
  };
  const auto in_plane = [&](const glm::dvec3& by) { return by - glm::dot(by, *axis_) * *axis_; };
  if (is_in_plane_) return in_plane(stepped(in_plane(moved_in_plane(where))));
  if (axis_) {
    const auto from = nearest_on_axis(middle_, *axis_, ray_through(where.camera, where.view, start_));
    const auto to = nearest_on_axis(middle_, *axis_, ray_through(where.camera, where.view, where.pixel));
    const double along = from && to ? *to - *from : 0;
    return (step ? step->nearest_to(along) : along) * *axis_;
  }
  const double depth = depth_of(where.camera, middle_);
  return stepped(place_at(where.camera, where.view, where.pixel, depth) -
                 place_at(where.camera, where.view, start_, depth));
}

void TransformGesture::follow_move(const Where& where) {
  std::optional<RoundStep> step;
  if (where.snaps && !where.under)
    step = felt_step(where, units_per_pixel(where.camera, where.view, depth_of(where.camera, middle_)));
  const glm::dvec3 by = where.under ? moved_onto(where.under->place) : moved_by(where, step);
  if (is_finite(by)) transform_.by = by;
  snapped_to_ = where.under;
  step_ = step ? std::optional(step->size()) : std::nullopt;
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
  transform_.angle_deg = stepped(turned_deg_, turn_step, where);
}

void TransformGesture::follow_scale(const Where& where) {
  transform_.axis = axis_;
  const auto centre = project(where.camera, where.view, middle_);
  if (!centre) return;
  const glm::dvec2 a = start_ - centre->pixel, b = where.pixel - centre->pixel;
  constexpr double least_px = 8;  // nearer to the middle a pixel would be too much
  const double from = std::max(glm::length(a), least_px);
  const double factor = (glm::dot(a, b) < 0 ? -1 : 1) * glm::length(b) / from;
  transform_.factor = stepped(factor, scale_step, where);
}

void TransformGesture::take_number() {
  const auto number = parse_double(typed_);
  if (!number) return;
  if (kind_ == PointTransform::Kind::move) transform_.by = *number * typed_direction();
  if (kind_ == PointTransform::Kind::turn) transform_.angle_deg = *number;
  if (kind_ == PointTransform::Kind::scale) transform_.factor = *number;
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
  if (kind_ == PointTransform::Kind::move) return transform_.by == glm::dvec3(0);
  if (kind_ == PointTransform::Kind::turn) return transform_.angle_deg == 0;
  return transform_.factor == 1;
}

std::optional<glm::dvec3> TransformGesture::movement() const {
  if (kind_ != PointTransform::Kind::move || falloff_ > 0) return std::nullopt;
  return transform_.by;
}

namespace {

// " X", or the plane across it as " YZ".
std::string axis_name(char letter, bool in_plane) {
  if (letter == 0) return "";
  if (!in_plane) return std::string(1, ' ') + letter;
  return letter == 'X' ? " YZ" : letter == 'Y' ? " ZX" : letter == 'Z' ? " XY" : " ⊥N";
}

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

AlgorithmCall TransformGesture::call() const {
  const auto called = [](std::string_view id) {
    const AlgorithmRow& row = *find_algorithm(id);
    return AlgorithmCall{&row, ParameterValues(row.parameters)};
  };
  AlgorithmCall call = called(kind_ == PointTransform::Kind::move   ? "translate"
                              : kind_ == PointTransform::Kind::turn ? "rotate"
                                                                    : "scale");
  if (kind_ == PointTransform::Kind::move) call.values.set_place("by", transform_.by);
  if (kind_ == PointTransform::Kind::turn) call.values.set_number("angle", transform_.angle_deg);
  if (kind_ == PointTransform::Kind::scale) call.values.set_number("factor", transform_.factor);
  if (kind_ != PointTransform::Kind::move) {
    if (transform_.axis) call.values.set_place("axis", *transform_.axis);
    call.values.set_place("about", middle_);
  }
  if (falloff_ > 0) call.values.set_length("falloff", falloff_);
  Elements points(points_.begin(), points_.end());
  const std::string ranges = slot_ranges(points);
  const std::vector<std::string_view> names = split_words(ranges);
  call.values.set_elements("elements", std::move(points), {names.begin(), names.end()});
  return call;
}

// What is held, and what it is on; or in what steps it goes.
Text TransformGesture::told_snap() const {
  if (!typed_.empty()) return {};
  if (!snapped_to_) {
    if (!step_) return {};
    const std::string step = short_text(*step_);
    return {", in steps of " + step, "、" + step + " 刻み"};
  }
  const bool is_on_it = !axis_;
  const bool is_edge = snapped_to_->element.kind == Element::Kind::edge;
  const std::string &name = snapped_to_->name, &held = held_name_;
  return {", " + (held.empty() ? "the middle" : held) + (is_on_it ? " on " : " level with ") +
              (is_edge ? "edge " : "") + name,
          "、" + (held.empty() ? "中心" : held) + "を" + (is_edge ? "稜線 " : " ") + name +
              (is_on_it ? " に吸着" : " の位置に揃える")};
}

Text TransformGesture::told() const {
  Text text;
  const std::string letter = axis_name(axis_letter_, is_in_plane_);
  switch (kind_) {
    case PointTransform::Kind::move: {
      const glm::dvec3& by = transform_.by;
      const std::string amount = axis_ && !is_in_plane_
                                     ? short_text(glm::dot(by, *axis_))
                                     : short_text(by.x) + ", " + short_text(by.y) + ", " + short_text(by.z);
      text = {called_.en + letter + " " + amount, called_.ja + letter + " " + amount};
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
  text += told_snap();
  if (!typed_.empty()) text += Text{" [" + typed_ + "]", " [" + typed_ + "]"};
  if (falloff_ > 0) text += Text{", falloff " + short_text(falloff_), "、減衰半径 " + short_text(falloff_)};
  return text;
}

}  // namespace ryosen
