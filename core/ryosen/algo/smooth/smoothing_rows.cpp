#include "ryosen/algo/algorithm_rows.h"

#include "ryosen/algo/smooth/smooth.h"
#include "ryosen/algo/transform/moved_points.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/rows.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// A choice and what it stands for.
template <class Value>
struct ChoiceOf {
  Value value;
  std::string_view id, en, ja;
};
constexpr ChoiceOf<smooth::Method> methods[] = {{smooth::Method::laplace, "laplace", "Laplace", "ラプラシアン"},
                                                {smooth::Method::implicit, "implicit", "Implicit", "陰解法"},
                                                {smooth::Method::taubin, "taubin", "Taubin", "Taubin"}};
constexpr ChoiceOf<smooth::WeightKind> weight_kinds[] = {
    {smooth::WeightKind::cotangent, "cotangent", "Cotangent", "余接"},
    {smooth::WeightKind::uniform, "uniform", "Uniform", "均一"}};
constexpr ChoiceOf<smooth::BoundaryRule> boundary_rules[] = {
    {smooth::BoundaryRule::locked, "locked", "Locked", "固定"},
    {smooth::BoundaryRule::sliding, "sliding", "Sliding", "境界に沿う"},
    {smooth::BoundaryRule::free, "free", "Free", "自由"}};

template <class Value, std::size_t n>
Value chosen(std::string_view id, const ChoiceOf<Value> (&choices)[n]) {
  const auto* const row = find_row(choices, id);
  return row ? row->value : choices[0].value;
}

smooth::Options options_of_smoothing(const ParameterValues& values) {
  return {.method = chosen(values.choice("method"), methods),
          .weights = chosen(values.choice("weights"), weight_kinds),
          .boundary = chosen(values.choice("boundary"), boundary_rules),
          .steps = values.count("steps"),
          .strength = values.number("strength"),
          .pass_band = values.number("pass_band"),
          .keeps_volume = values.flag("keep_volume")};
}

std::vector<double> shares_of(const Mesh& mesh, const ParameterValues& values) {
  if (!values.has("select")) return std::vector<double>(mesh.vertex_slots(), 1.0);
  std::vector<double> shares(mesh.vertex_slots(), 0.0);
  const double radius = values.has("falloff") ? values.length("falloff") : 0;
  for (const MovedPoint& each : moved_points(mesh, points_of(mesh, values.elements("select")), radius))
    shares[each.point.index] = each.share;
  return shares;
}

std::optional<Text> fault_of_smoothing(const smooth::Options& options) {
  if (options.method != smooth::Method::implicit && options.strength > 1)
    return Text{"a strength above 1 needs the implicit method; the others would not settle",
                "1 を超える強さは陰解法（implicit）でのみ使えます"};
  if (options.method == smooth::Method::taubin && options.pass_band * options.strength >= 1)
    return Text{"the pass band must be less than 1 divided by the strength",
                "通過帯域は 1 / 強さ より小さくしてください"};
  return std::nullopt;
}

Text volume_text(const smooth::KeptVolume& kept) {
  Text text =
      count_text(kept.parts, "; one part kept its volume", "; # parts kept their volume", "（部分 # 個の体積を保持）");
  if (kept.open_parts > 0)
    text +=
        count_text(kept.open_parts, "; one part has no volume, since it is not closed",
                   "; # parts have no volume, since they are not closed", "（閉じていない部分 # 個には体積がない）");
  if (kept.failed_parts > 0)
    text += count_text(kept.failed_parts, "; one part could not get its volume back",
                       "; # parts could not get their volume back", "（部分 # 個の体積は元に戻せない）");
  return text;
}

AlgorithmResult smooth_mesh(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Mesh& mesh = edit.mesh();
  const smooth::Options options = options_of_smoothing(input.values);
  if (mesh.live().faces == 0) return {.refused = Text{"there are no faces", "面がありません"}};
  AlgorithmResult result;
  if ((result.fault = fault_of_smoothing(options))) return result;
  const smooth::Smoothed made = smooth::smoothed(mesh, options, shares_of(mesh, input.values), progress);
  if (made.is_cancelled) return result;
  result.goal_report.emplace();
  for (const Vertex v : live_vertices(mesh)) {
    if (point(mesh, v) != v || made.places[v.index] == mesh.position(v) || !is_finite(made.places[v.index])) continue;
    move_point(edit, v, made.places[v.index]);
    ++result.changed;
  }
  result.text = count_text(result.changed, "One vertex was moved", "# vertices were moved", "頂点 # 個を動かしました");
  if (options.keeps_volume) result.text += volume_text(made.volume);
  result.text += Text{".", "。"};
  return result;
}

template <class Choices>
ParameterRow choice_row(const RowWords& words, const Choices& choices) {
  return parameter_row(words,
                       {.kind = ParameterKind::choice, .initial = choices[0].id, .choices = choices_of(choices)});
}

std::vector<ParameterRow> smoothing_parameters() {
  return {
      choice_row(
          {"method", "Method", "方法",
           "laplace moves towards the neighbours, implicit takes large steps at once, taubin hardly shrinks or grows",
           "laplace は近傍へ動かし、implicit は大きな一歩を安定に進め、taubin はほとんど縮まない"},
          methods),
      parameter_row({"steps", "Steps", "回数", "how often", "繰り返す回数"},
                    {.kind = ParameterKind::count, .initial = "10", .smallest = 1, .largest = 1000000}),
      parameter_row(
          {"strength", "Strength", "強さ",
           "the share of the way to the neighbours, at most 1; of implicit steps any number",
           "近傍へ動く割合（1 以下。陰解法では任意の正の数）"},
          {.kind = ParameterKind::number, .initial = "0.5", .smallest = 0, .largest = 1e12, .excludes_smallest = true}),
      choice_row({"weights", "Weights", "重み",
                  "how much each neighbour counts: by the angles across from it (not below 0), or all alike",
                  "近傍の重み：向かいの角の余接（負は 0）、またはすべて等しく"},
                 weight_kinds),
      choice_row({"boundary", "Boundary", "境界",
                  "boundary vertices stay, move along the boundary (its corners stay), or move as all others",
                  "境界の頂点を固定するか、境界に沿って動かす（角は固定）か、他と同じに動かす"},
                 boundary_rules),
      parameter_row(
          {"keep_volume", "Keep the volume", "体積を保つ", "gives each closed part its volume back, along the normals",
           "閉じた部分ごとに、法線方向へ動かして元の体積に戻す"},
          {.kind = ParameterKind::flag, .initial = "off"}),
      parameter_row(
          {"pass_band", "Pass band", "通過帯域", "of taubin: what varies more slowly stays",
           "taubin で、これより緩やかな変化を残す"},
          {.kind = ParameterKind::number, .initial = "0.1", .smallest = 0, .largest = 2, .excludes_smallest = true}),
      parameter_row({"falloff", "Falloff", "減衰半径",
                     "vertices nearer than this to the selection are smoothed too, less and less with the distance",
                     "対象からこの距離より近い頂点も、遠いほど弱く滑らかにする"},
                    {.kind = ParameterKind::length}),
      parameter_row({"select", "Select", "対象", "the vertices, or those of these edges and faces; else all",
                     "滑らかにする頂点、または稜線や面（省くとすべて）"},
                    {.kind = ParameterKind::elements, .is_worked_on = true}),
  };
}

}  // namespace

std::vector<AlgorithmRow> smoothing_rows() {
  return {algorithm_row(
      {"smooth", "Smooth", "平滑化", "moves vertices towards their neighbours, so that the surface becomes smooth",
       "頂点を近傍へ動かし、曲面を滑らかにする"},
      {.parameters = smoothing_parameters(), .run = smooth_mesh, .has_goal = true})};
}

}  // namespace ryosen
