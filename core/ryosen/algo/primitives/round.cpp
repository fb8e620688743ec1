#include "ryosen/algo/primitives/round.h"

#include "ryosen/algo/primitives/shape.h"
#include "ryosen/base/number_text.h"

namespace ryosen {

namespace {

// The places of a circle about the Y axis in the order of `around`, counter-clockwise seen from above; the first of
// them.
std::uint32_t add_circle(Shape& shape, const std::vector<glm::dvec2>& around, double radius, double height) {
  std::uint32_t first = no_index;
  for (const glm::dvec2& p : around) {
    const std::uint32_t point = shape.add_point({radius * p.x, height, -radius * p.y});
    if (first == no_index) first = point;
  }
  return first;
}

// Quads between two circles, of which the lower one, seen from outside, is the first.
void add_band(Shape& shape, std::uint32_t lower, std::uint32_t upper, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    shape.add_face({lower + i, lower + j, upper + j, upper + i});
  }
}

enum class Facing { up, down };

// Triangles between a circle and a point on the axis.
void add_fan(Shape& shape, std::uint32_t circle, std::uint32_t count, std::uint32_t tip, Facing facing) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    if (facing == Facing::up)
      shape.add_face({circle + i, circle + j, tip});
    else
      shape.add_face({circle + j, circle + i, tip});
  }
}

// Closes a circle as `caps` says.
void add_cap(Shape& shape, std::uint32_t circle, std::uint32_t count, double height, Facing facing,
             std::string_view caps) {
  if (caps == "fan") return add_fan(shape, circle, count, shape.add_point({0, height, 0}), facing);
  if (caps != "polygon") return;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < count; ++i) corners.push_back(circle + (facing == Facing::up ? i : count - 1 - i));
  shape.add_face(corners);
}

}  // namespace

AlgorithmResult add_sphere(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const double radius = values.length("radius");
  const auto segments = static_cast<std::uint32_t>(values.count("segments"));
  const std::size_t bands = values.count("bands");
  const std::vector<glm::dvec2> around = points_on_circle(segments), meridian = points_on_circle(2 * bands);
  Shape shape(values.place("at"));
  const std::uint32_t top = shape.add_point({0, radius, 0}), bottom = shape.add_point({0, -radius, 0});
  std::uint32_t upper = no_index;
  for (std::size_t band = 1; band < bands; ++band) {
    const std::uint32_t circle = add_circle(shape, around, radius * meridian[band].y, radius * meridian[band].x);
    if (band == 1)
      add_fan(shape, circle, segments, top, Facing::up);
    else
      add_band(shape, circle, upper, segments);
    upper = circle;
  }
  add_fan(shape, upper, segments, bottom, Facing::down);
  return std::move(shape).add_to(edit, progress);
}

AlgorithmResult add_cylinder(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const double radius = values.length("radius"), top = values.length("height") / 2;
  const auto segments = static_cast<std::uint32_t>(values.count("segments"));
  const std::vector<glm::dvec2> around = points_on_circle(segments);
  Shape shape(values.place("at"));
  const std::uint32_t lower = add_circle(shape, around, radius, -top), upper = add_circle(shape, around, radius, top);
  add_band(shape, lower, upper, segments);
  add_cap(shape, lower, segments, -top, Facing::down, values.choice("caps"));
  add_cap(shape, upper, segments, top, Facing::up, values.choice("caps"));
  return std::move(shape).add_to(edit, progress);
}

AlgorithmResult add_cone(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const double radius = values.length("radius"), top = values.length("height") / 2;
  const auto segments = static_cast<std::uint32_t>(values.count("segments"));
  Shape shape(values.place("at"));
  const std::uint32_t base = add_circle(shape, points_on_circle(segments), radius, -top);
  add_fan(shape, base, segments, shape.add_point({0, top, 0}), Facing::up);
  add_cap(shape, base, segments, -top, Facing::down, values.choice("caps"));
  return std::move(shape).add_to(edit, progress);
}

AlgorithmResult add_torus(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const double radius = values.length("radius"), tube = values.length("tube");
  if (!(tube < radius)) {
    AlgorithmResult result;
    const std::string t = format_double(tube), r = format_double(radius);
    result.fault =
        Text{"the radius of the tube (" + t + ") must be less than that of the circle it follows (" + r + ")",
             "管の半径（" + t + "）は中心円の半径（" + r + "）より小さくしてください"};
    return result;
  }
  const auto segments = static_cast<std::uint32_t>(values.count("segments"));
  const std::vector<glm::dvec2> around = points_on_circle(segments),
                                section = points_on_circle(values.count("tube_segments"));
  Shape shape(values.place("at"));
  std::vector<std::uint32_t> circles;
  for (const glm::dvec2& p : section) circles.push_back(add_circle(shape, around, radius + tube * p.x, tube * p.y));
  for (std::size_t i = 0; i < circles.size(); ++i)
    add_band(shape, circles[i], circles[(i + 1) % circles.size()], segments);
  return std::move(shape).add_to(edit, progress);
}

}  // namespace ryosen
