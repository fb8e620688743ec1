// How a gesture is told while it lasts, and as the command that it ends with.
#include <glm/geometric.hpp>

#include "app/editor/commands/text/words.h"
#include "app/editor/shown/transform_gesture.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/names.h"

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
  const Elements points(points_.begin(), points_.end());
  const std::string ranges = slot_ranges(points);
  std::vector<std::string> names;
  for (const std::string_view name : split_words(ranges)) names.emplace_back(name);
  call.values.set_names("elements", std::move(names));
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
  text = text + told_snap();
  if (!typed_.empty()) text = text + Text{" [" + typed_ + "]", " [" + typed_ + "]"};
  if (falloff_ > 0) text = text + Text{", falloff " + short_text(falloff_), "、減衰半径 " + short_text(falloff_)};
  return text;
}

}  // namespace ryosen
