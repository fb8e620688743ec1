#include "ryosen/algo/algorithm_rows.h"

#include "ryosen/algo/transform/moved_points.h"
#include "ryosen/base/count_text.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

std::vector<Vertex> all_points(const Mesh& mesh) {
  std::vector<Vertex> points;
  for (const Vertex v : live_vertices(mesh))
    if (point(mesh, v) == v) points.push_back(v);
  return points;
}

std::vector<Vertex> points_meant(const Mesh& mesh, const ParameterValues& values) {
  return values.has("elements") ? points_of(mesh, values.elements("elements")) : all_points(mesh);
}

AlgorithmResult too_far(const Mesh& mesh, Vertex v) {
  AlgorithmResult result;
  const std::string name = name_of(mesh, v);
  result.fault = Text{name + " would come to a place that is not finite", name + " の座標が有限でなくなります"};
  return result;
}

AlgorithmResult apply(Edit& edit, const AlgorithmInput& input, const PointTransform& transform, Progress& progress) {
  const Mesh& mesh = edit.mesh();
  const double radius = input.values.has("falloff") ? input.values.length("falloff") : 0;
  const std::vector<MovedPoint> moved = moved_points(mesh, points_meant(mesh, input.values), radius);
  AlgorithmResult result;
  for (const MovedPoint& each : moved) {
    if (!progress.go_on(static_cast<std::size_t>(&each - moved.data()), moved.size())) return result;
    const glm::dvec3 before = mesh.position(each.point);
    if (!is_finite(before)) continue;
    const glm::dvec3 after = transform(before, each.share);
    if (!is_finite(after)) return too_far(mesh, each.point);
    if (after == before) continue;
    move_point(edit, each.point, after);
    ++result.changed;
  }
  result.text =
      count_text(result.changed, "One vertex was moved.", "# vertices were moved.", "頂点 # 個を動かしました。");
  return result;
}

glm::dvec3 centre(const Mesh& mesh, const ParameterValues& values) {
  return values.has("about") ? values.place("about") : middle_of(mesh, points_meant(mesh, values));
}

AlgorithmResult no_direction() {
  AlgorithmResult result;
  result.fault = Text{"the axis has no direction", "軸に向きがありません"};
  return result;
}

AlgorithmResult translate(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  return apply(edit, input, {.kind = PointTransform::Kind::move, .by = input.values.place("by"), .axis = {}}, progress);
}

AlgorithmResult rotate(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const auto axis = direction_of(input.values.place("axis"));
  if (!axis) return no_direction();
  return apply(edit, input,
               {.kind = PointTransform::Kind::turn,
                .angle_deg = input.values.number("angle"),
                .axis = axis,
                .about = centre(edit.mesh(), input.values)},
               progress);
}

AlgorithmResult scale(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  std::optional<glm::dvec3> axis;
  if (input.values.has("axis") && !(axis = direction_of(input.values.place("axis")))) return no_direction();
  return apply(edit, input,
               {.kind = PointTransform::Kind::scale,
                .factor = input.values.number("factor"),
                .axis = axis,
                .about = centre(edit.mesh(), input.values)},
               progress);
}

ParameterRow about() {
  return parameter_row({"about", "About", "中心", "what stays where it is; else the middle of what is moved",
                        "動かない点（省くと対象の中央）"},
                       {.kind = ParameterKind::place});
}

std::vector<ParameterRow> with_common(std::vector<ParameterRow> rows) {
  rows.push_back(parameter_row(
      {"falloff", "Falloff", "減衰半径", "vertices nearer than this come along, less and less with the distance",
       "この距離より近い頂点も、遠いほど少なく動かす"},
      {.kind = ParameterKind::length}));
  rows.push_back(
      parameter_row({"elements", "Elements", "対象", "the vertices, or those of these edges and faces; else all",
                     "動かす頂点、または稜線や面（省くとすべて）"},
                    {.kind = ParameterKind::elements, .is_worked_on = true}));
  return rows;
}

ParameterRow axis(std::string_view help_en, std::string_view help_ja, std::string_view initial) {
  return parameter_row({"axis", "Axis", "軸", help_en, help_ja}, {.kind = ParameterKind::place, .initial = initial});
}

}  // namespace

std::vector<AlgorithmRow> transform_rows() {
  return {
      algorithm_row({"translate", "Move", "移動", "moves vertices by a vector", "頂点をベクトルだけ動かす"},
                    {.parameters = with_common(
                         {parameter_row({"by", "By", "移動量", "how far along X, Y and Z", "X、Y、Z 方向の移動量"},
                                        {.kind = ParameterKind::place, .is_required = true})}),
                     .run = translate}),
      algorithm_row(
          {"rotate", "Turn", "回転", "turns vertices about an axis", "頂点を軸のまわりに回す"},
          {.parameters = with_common(
               {parameter_row(
                    {"angle", "Angle", "角度", "counter-clockwise seen against the axis", "軸の先から見て反時計回り"},
                    {.kind = ParameterKind::number, .is_required = true, .unit_en = "degrees", .unit_ja = "度"}),
                axis("the direction of the axis", "軸の向き", "0,1,0"), about()}),
           .run = rotate}),
      algorithm_row({"scale", "Scale", "拡大縮小", "scales vertices, everywhere or along an axis",
                     "頂点を全方向または軸方向に拡大縮小する"},
                    {.parameters = with_common(
                         {parameter_row({"factor", "Factor", "倍率", "1 changes nothing; a negative one mirrors",
                                         "1 で変化なし、負の値で反転"},
                                        {.kind = ParameterKind::number, .is_required = true}),
                          axis("scales along this direction alone; else everywhere",
                               "この向きだけ拡大縮小する（省くと全方向）", ""),
                          about()}),
                     .run = scale})};
}

}  // namespace ryosen
