// Primitives: a grid, the regular solids, and what is round about the Y axis.
#include "ryosen/algo/algorithm_rows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "ryosen/algo/primitives/shape.h"
#include "ryosen/base/number_text.h"

namespace ryosen {

namespace {

// From -extent / 2 to extent / 2, both exactly.
double line_at(std::size_t i, std::size_t count, double extent) {
  const auto twice = 2 * static_cast<double>(i), all = static_cast<double>(count);
  return extent / 2 * ((twice - all) / all);
}

// In the plane of X and Z, seen from above (+Y) counter-clockwise.
AlgorithmResult add_grid(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const std::size_t columns = values.count("columns"), rows = values.count("rows");
  Shape shape(values.place("at"));
  for (std::size_t row = 0; row <= rows; ++row)
    for (std::size_t column = 0; column <= columns; ++column)
      shape.add_point(
          {line_at(column, columns, values.length("width")), 0, line_at(row, rows, values.length("depth"))});
  const auto line = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t corner = row * line + column;
      shape.add_face({corner, corner + line, corner + line + 1, corner + 1});
    }
  return std::move(shape).add_to(edit, progress);
}

using Directions = std::vector<glm::dvec3>;

// Of each solid its vertices; they are the directions of the faces of its dual.
Directions tetrahedron_vertices() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

Directions tetrahedron_faces() {
  Directions faces = tetrahedron_vertices();
  for (glm::dvec3& direction : faces) direction = -direction;
  return faces;
}

Directions octahedron_vertices() { return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}; }

Directions cube_vertices() {
  Directions all;
  for (int z = -1; z <= 1; z += 2)
    for (int y = -1; y <= 1; y += 2)
      for (int x = -1; x <= 1; x += 2) all.emplace_back(x, y, z);
  return all;
}

// (0, +-a, +-b) and what turning the axes makes of them: the corners of three rectangles.
Directions rectangles(double a, double b) {
  Directions all;
  for (int axis = 0; axis < 3; ++axis)
    for (const double first : {a, -a})
      for (const double second : {b, -b}) {
        glm::dvec3 place(0);
        place[(axis + 1) % 3] = first;
        place[(axis + 2) % 3] = second;
        all.push_back(place);
      }
  return all;
}

Directions icosahedron_vertices() { return rectangles(1, std::numbers::phi); }

Directions dodecahedron_vertices() {
  Directions all = cube_vertices();
  const Directions others = rectangles(std::numbers::phi, 1 / std::numbers::phi);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

// The vertices farthest in a direction, counter-clockwise seen from there.
std::vector<std::uint32_t> face_in(const glm::dvec3& direction, const Directions& vertices) {
  constexpr double tolerance = 1e-9;
  double farthest = 0;
  for (const glm::dvec3& v : vertices) farthest = std::max(farthest, glm::dot(v, direction));
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    if (glm::dot(vertices[i], direction) > farthest - tolerance) corners.push_back(i);
  const glm::dvec3 first = vertices[corners[0]] - direction * (farthest / glm::dot(direction, direction));
  const glm::dvec3 beside = glm::cross(direction, first) / glm::length(direction);
  const auto turn = [&](std::uint32_t i) {
    const double angle = std::atan2(glm::dot(vertices[i], beside), glm::dot(vertices[i], first));
    return angle < -tolerance ? angle + 2 * std::numbers::pi : angle;
  };
  std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) { return turn(a) < turn(b); });
  return corners;
}

AlgorithmResult add_solid(Edit& edit, const AlgorithmInput& input, Progress& progress, const Directions& vertices,
                          const Directions& faces, double scale) {
  Shape shape(input.values.place("at"));
  for (const glm::dvec3& v : vertices) shape.add_point(scale * v);
  for (const glm::dvec3& direction : faces) shape.add_face(face_in(direction, vertices));
  return std::move(shape).add_to(edit, progress);
}

// By the length of its edges, along the axes.
AlgorithmResult add_cube(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  return add_solid(edit, input, progress, cube_vertices(), octahedron_vertices(), input.values.length("size") / 2);
}

// Another one by the radius of the sphere through its vertices.
template <Directions (*vertices)(), Directions (*faces)()>
AlgorithmResult add_within_sphere(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const double scale = input.values.length("radius") / glm::length(vertices()[0]);
  return add_solid(edit, input, progress, vertices(), faces(), scale);
}

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

// Quads between circles of latitude, triangles at the poles.
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

// Quads around; at each end one polygon, a fan of triangles, or nothing.
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

// Triangles around, the tip up; its base is as that of a cylinder.
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

// Quads. The tube must be thinner than the circle that it follows.
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

// With both counts of a shape at this a million faces are added, in about 300 MB.
constexpr double most_parts = 1000;

ParameterRow length(const RowWords& words, std::string_view initial) {
  return parameter_row(words,
                       {.kind = ParameterKind::length, .initial = initial, .smallest = 0, .excludes_smallest = true});
}

ParameterRow parts(const RowWords& words, std::string_view initial, double least) {
  return parameter_row(words,
                       {.kind = ParameterKind::count, .initial = initial, .smallest = least, .largest = most_parts});
}

ParameterRow radius(std::string_view help_en, std::string_view help_ja) {
  return length({"radius", "Radius", "半径", help_en, help_ja}, "1");
}

ParameterRow height() { return length({"height", "Height", "高さ", "along Y", "Y 方向の長さ"}, "2"); }

ParameterRow segments() {
  return parts({"segments", "Segments", "分割数", "parts of a full turn about Y", "Y 軸まわりの分割数"}, "32", 3);
}

ParameterRow caps(std::string_view help_en, std::string_view help_ja) {
  return parameter_row({"caps", "Caps", "底面", help_en, help_ja},
                       {.kind = ParameterKind::choice,
                        .initial = "polygon",
                        .choices = {{"polygon", "One polygon", "一つの多角形"},
                                    {"fan", "A fan of triangles", "三角形の扇"},
                                    {"none", "None", "なし"}}});
}

AlgorithmRow primitive(const RowWords& words, std::vector<ParameterRow> parameters,
                       AlgorithmResult (*run)(Edit&, const AlgorithmInput&, Progress&)) {
  parameters.push_back(parameter_row({"at", "Centre", "中心", "where the middle of the shape lies", "形状の中心の位置"},
                                     {.kind = ParameterKind::place, .initial = "0,0,0"}));
  return algorithm_row(words, {.parameters = std::move(parameters),
                               .keeps_geometry = true,
                               .run = run,
                               .is_primitive = true,
                               .selects_added = true});
}

ParameterRow circumradius() { return radius("from the centre to each vertex", "中心から頂点までの距離"); }

}  // namespace

std::vector<AlgorithmRow> primitive_rows() {
  return {
      primitive({"grid", "Grid", "格子", "adds a floor of quads, which faces up (+Y)",
                 "上（+Y）を向いた四角形の格子を追加する"},
                {length({"width", "Width", "幅", "along X", "X 方向の長さ"}, "2"),
                 length({"depth", "Depth", "奥行き", "along Z", "Z 方向の長さ"}, "2"),
                 parts({"columns", "Columns", "列数", "quads along X", "X 方向の面の数"}, "10", 1),
                 parts({"rows", "Rows", "行数", "quads along Z", "Z 方向の面の数"}, "10", 1)},
                add_grid),
      primitive({"cube", "Cube", "立方体", "adds a cube of six quads along the axes", "座標軸に沿った立方体を追加する"},
                {length({"size", "Size", "大きさ", "length of its edges", "稜線の長さ"}, "2")}, add_cube),
      primitive({"tetrahedron", "Tetrahedron", "正四面体", "adds a regular solid of 4 triangles", "正四面体を追加する"},
                {circumradius()}, add_within_sphere<tetrahedron_vertices, tetrahedron_faces>),
      primitive({"octahedron", "Octahedron", "正八面体", "adds a regular solid of 8 triangles", "正八面体を追加する"},
                {circumradius()}, add_within_sphere<octahedron_vertices, cube_vertices>),
      primitive({"dodecahedron", "Dodecahedron", "正十二面体", "adds a regular solid of 12 pentagons",
                 "正十二面体を追加する"},
                {circumradius()}, add_within_sphere<dodecahedron_vertices, icosahedron_vertices>),
      primitive(
          {"icosahedron", "Icosahedron", "正二十面体", "adds a regular solid of 20 triangles", "正二十面体を追加する"},
          {circumradius()}, add_within_sphere<icosahedron_vertices, dodecahedron_vertices>),
      primitive(
          {"sphere", "Sphere", "球", "adds a sphere of quads between circles of latitude, triangles at the poles",
           "緯線と経線で分けた球を追加する（極は三角形、他は四角形）"},
          {circumradius(), segments(),
           parts({"bands", "Bands", "段数", "rows of faces from pole to pole", "極から極までの面の段数"}, "16", 2)},
          add_sphere),
      primitive({"cylinder", "Cylinder", "円柱", "adds a cylinder about Y, quads around", "Y 軸まわりの円柱を追加する"},
                {radius("of its circles", "円の半径"), height(), segments(),
                 caps("how its ends are closed", "両端のふさぎ方")},
                add_cylinder),
      primitive(
          {"cone", "Cone", "円錐", "adds a cone about Y, its tip up", "Y 軸まわりの、頂点が上の円錐を追加する"},
          {radius("of its base", "底面の半径"), height(), segments(), caps("how its base is closed", "底面のふさぎ方")},
          add_cone),
      primitive({"torus", "Torus", "トーラス", "adds a tube of quads along a circle about Y",
                 "Y 軸まわりの円に沿った四角形の管を追加する"},
                {radius("of the circle that the tube follows", "管の中心が通る円の半径"),
                 length({"tube", "Tube radius", "管の半径", "of the tube itself, less than the other radius",
                         "管の太さ（中心円の半径より小さいこと）"},
                        "0.25"),
                 segments(),
                 parts({"tube_segments", "Tube segments", "管の分割数", "parts of a turn around the tube",
                        "管を一周する分割数"},
                       "16", 3)},
                add_torus),
  };
}

}  // namespace ryosen
