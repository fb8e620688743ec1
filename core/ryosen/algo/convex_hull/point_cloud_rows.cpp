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
    return {.fault = Text{"the values are too large for places", "値が大きすぎて座標で表せません"}};
  }
  for (const glm::dvec3& p : points) edit.fresh(edit.add_vertex(p));
  result.changed = points.size();
  result.text = count_text(points.size(), "# point was added.", "# points were added.", "点を # 個追加しました。");
  return result;
}

std::vector<ParameterRow> parameters_of_points() {
  return {parameter_row({"family", "Family", "種類", "where they lie", "点の分布"},
                        {.kind = ParameterKind::choice, .initial = "ball", .choices = choices_of(point_families())}),
          parameter_row({"count", "Count", "個数", "how many points", "点の個数"},
                        {.kind = ParameterKind::count, .initial = "1000", .smallest = 1, .largest = 1e7}),
          parameter_row({"seed", "Seed", "乱数の種", "the same one gives the same points", "同じ値なら同じ点になる"},
                        {.kind = ParameterKind::count, .initial = "1"}),
          parameter_row({"radius", "Radius", "半径", "from the centre to the farthest along an axis",
                         "中心から座標軸方向に最も遠い点までの距離"},
                        {.kind = ParameterKind::length, .initial = "1", .smallest = 0, .excludes_smallest = true}),
          parameter_row({"at", "Centre", "中心", "where their middle lies", "中心の位置"},
                        {.kind = ParameterKind::place, .initial = "0,0,0"})};
}

}  // namespace

std::vector<AlgorithmRow> point_cloud_rows() {
  return {algorithm_row({"points", "Points", "点の集まり", "adds random points of a family, such as to try hulls on",
                         "ランダムな点を追加する（凸包などを試すため）"},
                        {.parameters = parameters_of_points(),
                         .keeps_geometry = true,
                         .run = add_points,
                         .is_primitive = true,
                         .selects_added = true,
                         .adds_points = true})};
}

}  // namespace ryosen
