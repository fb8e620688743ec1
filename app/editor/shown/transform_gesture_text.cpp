// How a gesture is told while it lasts, and as the command that it ends with.
#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/shown/transform_gesture.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/slot_ranges.h"

namespace ryosen {

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
  text = text + told_snap();
  if (!typed_.empty()) text = text + Text{" [" + typed_ + "]", " [" + typed_ + "]"};
  if (falloff_ > 0) text = text + Text{", falloff " + short_text(falloff_), "、減衰半径 " + short_text(falloff_)};
  return text;
}

}  // namespace ryosen
