#include "ryosen/algo/algorithm_rows.h"

#include "ryosen/base/count_text.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/hull/random_points.h"

namespace ryosen {

namespace {

AlgorithmResult add_points(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  PointFamily family = PointFamily::ball;
  for (const PointFamilyRow& row : point_families())
    if (row.id == values.choice("family")) family = row.family;
  AlgorithmResult result;
  std::vector<glm::dvec3> points = random_points(family, values.count("count"), values.count("seed"));
  if (!progress.go_on(1, 2)) return result;
  for (glm::dvec3& p : points) {
    p = values.place("at") + values.length("radius") * p;
    if (is_finite(p)) continue;
    result.fault = Text{"the values are too large for places", "値が大きすぎて座標で表せません"};
    return result;
  }
  for (const glm::dvec3& p : points) edit.add_vertex(p);
  result.changed = points.size();
  result.text = count_text(points.size(), "# point was added.", "# points were added.", "点を # 個追加しました。");
  return result;
}

std::vector<Choice> family_choices() {
  std::vector<Choice> choices;
  for (const PointFamilyRow& row : point_families()) choices.push_back({row.id, row.en, row.ja});
  return choices;
}

std::vector<ParameterRow> parameters_of_points() {
  return {{.id = "family",
           .kind = ParameterKind::choice,
           .name_en = "Family",
           .name_ja = "種類",
           .help_en = "where they lie",
           .help_ja = "点の分布",
           .initial = "ball",
           .choices = family_choices()},
          {.id = "count",
           .kind = ParameterKind::count,
           .name_en = "Count",
           .name_ja = "個数",
           .help_en = "how many points",
           .help_ja = "点の個数",
           .initial = "1000",
           .smallest = 1,
           .largest = 1e7},
          {.id = "seed",
           .kind = ParameterKind::count,
           .name_en = "Seed",
           .name_ja = "乱数の種",
           .help_en = "the same one gives the same points",
           .help_ja = "同じ値なら同じ点になる",
           .initial = "1"},
          {.id = "radius",
           .kind = ParameterKind::length,
           .name_en = "Radius",
           .name_ja = "半径",
           .help_en = "from the centre to the farthest along an axis",
           .help_ja = "中心から座標軸方向に最も遠い点までの距離",
           .initial = "1",
           .smallest = 0,
           .excludes_smallest = true},
          {.id = "at",
           .kind = ParameterKind::place,
           .name_en = "Centre",
           .name_ja = "中心",
           .help_en = "where their middle lies",
           .help_ja = "中心の位置",
           .initial = "0,0,0"}};
}

}  // namespace

std::vector<AlgorithmRow> point_cloud_rows() {
  return {{.id = "points",
           .name_en = "Points",
           .name_ja = "点の集まり",
           .help_en = "adds random points of a family, such as to try hulls on",
           .help_ja = "ランダムな点を追加する（凸包などを試すため）",
           .parameters = parameters_of_points(),
           .keeps_geometry = true,
           .solves = {},
           .run = add_points,
           .is_primitive = true,
           .selects_added = true,
           .adds_points = true}};
}

}  // namespace ryosen
