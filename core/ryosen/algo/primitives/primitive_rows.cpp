#include "ryosen/algo/algorithm_rows.h"

#include "ryosen/algo/primitives/grid.h"
#include "ryosen/algo/primitives/platonic.h"
#include "ryosen/algo/primitives/round.h"

namespace ryosen {

namespace {

// With both counts of a shape at this a million faces are added, in about 300 MB.
constexpr double most_parts = 1000;

struct Names {
  std::string_view id;
  std::string_view name_en, name_ja;
  std::string_view help_en, help_ja;
};

ParameterRow length(const Names& names, std::string_view initial) {
  return {.id = names.id,
          .kind = ParameterKind::length,
          .name_en = names.name_en,
          .name_ja = names.name_ja,
          .help_en = names.help_en,
          .help_ja = names.help_ja,
          .initial = initial,
          .smallest = 0,
          .excludes_smallest = true};
}

ParameterRow parts(const Names& names, std::string_view initial, double least) {
  return {.id = names.id,
          .kind = ParameterKind::count,
          .name_en = names.name_en,
          .name_ja = names.name_ja,
          .help_en = names.help_en,
          .help_ja = names.help_ja,
          .initial = initial,
          .smallest = least,
          .largest = most_parts};
}

ParameterRow radius(std::string_view help_en, std::string_view help_ja) {
  return length({"radius", "Radius", "半径", help_en, help_ja}, "1");
}

ParameterRow height() { return length({"height", "Height", "高さ", "along Y", "Y 方向の長さ"}, "2"); }

ParameterRow segments() {
  return parts({"segments", "Segments", "分割数", "parts of a full turn about Y", "Y 軸まわりの分割数"}, "32", 3);
}

ParameterRow caps(std::string_view help_en, std::string_view help_ja) {
  return {.id = "caps",
          .kind = ParameterKind::choice,
          .name_en = "Caps",
          .name_ja = "底面",
          .help_en = help_en,
          .help_ja = help_ja,
          .initial = "polygon",
          .choices = {{"polygon", "One polygon", "一つの多角形"},
                      {"fan", "A fan of triangles", "三角形の扇"},
                      {"none", "None", "なし"}}};
}

ParameterRow at() {
  return {.id = "at",
          .kind = ParameterKind::place,
          .name_en = "Centre",
          .name_ja = "中心",
          .help_en = "where the middle of the shape lies",
          .help_ja = "形状の中心の位置",
          .initial = "0,0,0"};
}

AlgorithmRow primitive(const Names& names, std::vector<ParameterRow> parameters,
                       AlgorithmResult (*run)(Edit&, const AlgorithmInput&, Progress&)) {
  parameters.push_back(at());
  return {.id = names.id,
          .name_en = names.name_en,
          .name_ja = names.name_ja,
          .help_en = names.help_en,
          .help_ja = names.help_ja,
          .parameters = std::move(parameters),
          .keeps_geometry = true,
          .solves = {},
          .run = run,
          .is_primitive = true,
          .selects_added = true};
}

ParameterRow circumradius() { return radius("from the centre to each vertex", "中心から頂点までの距離"); }

AlgorithmRow grid() {
  return primitive(
      {"grid", "Grid", "格子", "adds a floor of quads, which faces up (+Y)", "上（+Y）を向いた四角形の格子を追加する"},
      {length({"width", "Width", "幅", "along X", "X 方向の長さ"}, "2"),
       length({"depth", "Depth", "奥行き", "along Z", "Z 方向の長さ"}, "2"),
       parts({"columns", "Columns", "列数", "quads along X", "X 方向の面の数"}, "10", 1),
       parts({"rows", "Rows", "行数", "quads along Z", "Z 方向の面の数"}, "10", 1)},
      add_grid);
}

AlgorithmRow sphere() {
  return primitive(
      {"sphere", "Sphere", "球", "adds a sphere of quads between circles of latitude, triangles at the poles",
       "緯線と経線で分けた球を追加する（極は三角形、他は四角形）"},
      {circumradius(), segments(),
       parts({"bands", "Bands", "段数", "rows of faces from pole to pole", "極から極までの面の段数"}, "16", 2)},
      add_sphere);
}

AlgorithmRow torus() {
  return primitive(
      {"torus", "Torus", "トーラス", "adds a tube of quads along a circle about Y",
       "Y 軸まわりの円に沿った四角形の管を追加する"},
      {radius("of the circle that the tube follows", "管の中心が通る円の半径"),
       length({"tube", "Tube radius", "管の半径", "of the tube itself, less than the other radius",
               "管の太さ（中心円の半径より小さいこと）"},
              "0.25"),
       segments(),
       parts({"tube_segments", "Tube segments", "管の分割数", "parts of a turn around the tube", "管を一周する分割数"},
             "16", 3)},
      add_torus);
}

}  // namespace

std::vector<AlgorithmRow> primitive_rows() {
  return {
      grid(),
      primitive({"cube", "Cube", "立方体", "adds a cube of six quads along the axes", "座標軸に沿った立方体を追加する"},
                {length({"size", "Size", "大きさ", "length of its edges", "稜線の長さ"}, "2")}, add_cube),
      primitive({"tetrahedron", "Tetrahedron", "正四面体", "adds a regular solid of 4 triangles", "正四面体を追加する"},
                {circumradius()}, add_tetrahedron),
      primitive({"octahedron", "Octahedron", "正八面体", "adds a regular solid of 8 triangles", "正八面体を追加する"},
                {circumradius()}, add_octahedron),
      primitive({"dodecahedron", "Dodecahedron", "正十二面体", "adds a regular solid of 12 pentagons",
                 "正十二面体を追加する"},
                {circumradius()}, add_dodecahedron),
      primitive(
          {"icosahedron", "Icosahedron", "正二十面体", "adds a regular solid of 20 triangles", "正二十面体を追加する"},
          {circumradius()}, add_icosahedron),
      sphere(),
      primitive({"cylinder", "Cylinder", "円柱", "adds a cylinder about Y, quads around", "Y 軸まわりの円柱を追加する"},
                {radius("of its circles", "円の半径"), height(), segments(),
                 caps("how its ends are closed", "両端のふさぎ方")},
                add_cylinder),
      primitive(
          {"cone", "Cone", "円錐", "adds a cone about Y, its tip up", "Y 軸まわりの、頂点が上の円錐を追加する"},
          {radius("of its base", "底面の半径"), height(), segments(), caps("how its base is closed", "底面のふさぎ方")},
          add_cone),
      torus(),
  };
}

}  // namespace ryosen
