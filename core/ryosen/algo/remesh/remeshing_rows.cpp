#include "ryosen/algo/algorithm_rows.h"

#include <cmath>
#include <numbers>

#include "ryosen/algo/preparation.h"
#include "ryosen/algo/proposals.h"
#include "ryosen/algo/remesh/planar_regions.h"
#include "ryosen/algo/remesh/remesh.h"
#include "ryosen/algo/seams/seam_mode.h"
#include "ryosen/base/count_text.h"

namespace ryosen {

namespace {

Text refused_text(std::size_t refused) {
  if (refused == 0) return {};
  return count_text(refused, "; one step was left out since faces would have met",
                    "; # steps were left out since faces would have met", "（面どうしが交わる操作 # 回は行わず）");
}

void add_held_by_seams(AlgorithmResult& result, const std::vector<Edge>& edges, Text reason) {
  result.left += edges.size();
  add_left(result.left_for, std::move(reason), std::vector<Element>(edges.begin(), edges.end()));
}

AlgorithmResult remesh_mesh(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Mesh& mesh = edit.mesh();
  const ParameterValues& values = input.values;
  if (mesh.live().faces == 0) return {.refused = Text{"there are no faces", "面がありません"}};
  AlgorithmResult result;
  remesh::Options options{.length = values.length("length"),
                          .adaptive = values.flag("adaptive"),
                          .tolerance = values.has("tolerance") ? values.length("tolerance") : 0,
                          .rounds = values.count("rounds"),
                          .feature_angle_rad = values.angle_rad("feature_angle"),
                          .seams = seam_mode_of(values),
                          .on_lines = input.on_lines};
  if (!values.has("tolerance")) options.tolerance = options.length / 20;
  const std::size_t before = mesh.live().faces;
  Descent descent = edit.new_descent();
  remesh::Remeshed made = remesh::remeshed(mesh, options, progress, &descent);
  if (made.is_cancelled) return result;
  if ((result.fault = std::move(made.fault))) return result;
  result.goal_report.emplace();
  result.changed = made.columns.live.faces;
  const std::string after = std::to_string(made.columns.live.faces);
  result.text = count_text(before, "One face became " + after, "# faces became " + after,
                           "面 # 個が " + after + " 個になりました") +
                cut_text(made.cut_faces) + refused_text(made.refused);
  if (!made.held_by_seams.empty())
    result.text += count_text(made.held_by_seams.size(), "; one edge stays too short (seam; drop seams to let it go)",
                              "; # edges stay too short (seam; drop seams to let them go)",
                              "（シームに固定された短い稜線 # 本が残る。seams を drop にすると固定されない）");
  result.text += Text{".", "。"} + dropped_text(mesh, options.seams);
  add_held_by_seams(result, made.held_by_seams,
                    {"it would move a seam of texture or normals", "テクスチャや法線のシームが動きます"});
  if (values.has("tolerance") && !options.adaptive)
    result.text += Text{" The tolerance counts only where lengths are adaptive.",
                        "許容誤差は、曲率に適応させるときだけ効きます。"};
  edit.replace(std::move(made.columns), descent);
  return result;
}

AlgorithmResult swap_to_delaunay(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  AlgorithmResult result;
  Descent descent = edit.new_descent();
  const remesh::SwapOptions options{input.values.angle_rad("most_turn"), seam_mode_of(input.values)};
  const Text dropped = dropped_text(edit.mesh(), options.seams);
  remesh::Swapped made = remesh::delaunay_swapped(edit.mesh(), options, progress, &descent);
  if (made.is_cancelled) return result;
  if ((result.fault = std::move(made.fault))) return result;
  result.changed = made.swaps + made.cut_faces + (dropped.en.empty() ? 0 : 1);
  result.left = made.refused;
  result.text = count_text(made.swaps, "One edge was swapped", "# edges were swapped", "稜線 # 本を交換しました") +
                cut_text(made.cut_faces);
  if (made.refused > 0)
    result.text += count_text(made.refused, "; one is not Delaunay and stays", "; # are not Delaunay and stay",
                              "（交換できない稜線 # 本が残る）");
  if (!made.held_by_seams.empty())
    result.text +=
        count_text(made.held_by_seams.size(), "; one that is not Delaunay is a seam and stays (drop seams to swap it)",
                   "; # that are not Delaunay are seams and stay (drop seams to swap them)",
                   "（ドロネーでないシームの稜線 # 本は交換しない。seams を drop にすると交換する）");
  result.text += Text{".", "。"} + dropped;
  add_held_by_seams(result, made.held_by_seams,
                    {"a swap would tear a seam of texture or normals", "テクスチャや法線のシームが切れます"});
  if (result.changed > 0) edit.replace(std::move(made.columns), descent);
  return result;
}

AlgorithmResult unite_planar_regions(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const double angle_rad = input.values.angle_rad("angle"), distance = input.values.length("distance");
  AlgorithmResult result;
  const remesh::United united = remesh::unite_planar(edit, {angle_rad, distance}, progress);
  if (united.is_cancelled) return result;
  const bool drops = input.values.choice("straight") == "drop";
  const std::size_t dropped = drops ? remesh::drop_straight_corners(edit, {angle_rad, distance}, progress) : 0;
  if (progress.is_cancelled()) return result;
  result.changed = united.regions + dropped;
  result.left = united.left.size();
  const std::string faces = std::to_string(united.faces);
  result.text = Text{"No region of several faces is planar.", "多角形にまとめられる平らな領域はありません。"};
  if (united.regions > 0)
    result.text = count_text(united.regions, "One region of " + faces + " faces became a polygon.",
                             "# regions with " + faces + " faces in all became polygons.",
                             "合わせて面 " + faces + " 個の領域 # 個を多角形にまとめました。");
  if (dropped > 0)
    result.text +=
        count_text(dropped, " One corner on a straight edge was taken out.",
                   " # corners on straight edges were taken out.", "まっすぐな稜線上の角を # 個取り除きました。");
  std::vector<Element> left(united.left.begin(), united.left.end());
  add_left(result.left_for, {"the polygon would touch itself at a vertex", "まとめると多角形が頂点で自身に接します"},
           std::move(left));
  return result;
}

}  // namespace

std::vector<AlgorithmRow> remeshing_rows() {
  return {
      algorithm_row(
          {"remesh", "Remesh", "リメッシュ",
           "makes triangles of even edge lengths on the same surface; boundary and feature edges are only "
           "divided, their points stay",
           "同じ曲面上に稜線の長さのそろった三角形を作り直す（境界と特徴稜線は分割だけ、その頂点は固定）"},
          {.parameters = {parameter_row({"length", "Length", "長さ", "of the edges", "稜線の長さ"},
                                        {.kind = ParameterKind::length,
                                         .is_required = true,
                                         .smallest = 0,
                                         .excludes_smallest = true,
                                         .proposed = mean_edge_length_text}),
                          parameter_row({"adaptive", "Adaptive", "曲率に適応",
                                         "shorter edges where the surface bends, down to an eighth",
                                         "曲がった所ほど短くする（最小で八分の一）"},
                                        {.kind = ParameterKind::flag, .initial = "off"}),
                          parameter_row(
                              {"tolerance", "Tolerance", "許容誤差",
                               "of adaptive lengths: about how far triangles leave the surface, no bound; else a "
                               "twentieth of the length",
                               "適応時に三角形が曲面から離れる距離の目安（上限ではない。省くと長さの二十分の一）"},
                              {.kind = ParameterKind::length, .smallest = 0, .excludes_smallest = true}),
                          parameter_row({"rounds", "Rounds", "回数",
                                         "how often edges are split, collapsed and swapped and points moved",
                                         "分割・削除・交換・移動を繰り返す回数"},
                                        {.kind = ParameterKind::count, .initial = "5", .smallest = 1, .largest = 1000}),
                          parameter_row({"feature_angle", "Feature angle", "特徴角",
                                         "edges whose faces bend by at least this are features",
                                         "両側の面がこの角度以上に曲がる稜線を特徴として保つ"},
                                        {.kind = ParameterKind::angle, .initial = "45"}),
                          seams_row("weigh lets points leave along seams of texture and normals, and makes normals of "
                                    "flat faces anew; keep only divides all seams; drop forgets texture and normals",
                                    "weigh はテクスチャと法線のシームに沿って頂点を減らし、平坦な面の法線を作り直す。"
                                    "keep はすべてのシームを分割だけにする。drop はテクスチャと法線を捨てる")},
           .run = remesh_mesh,
           .lineage = Lineage::lost,
           .has_goal = true}),
      algorithm_row({"delaunay", "Delaunay swaps", "ドロネー交換",
                     "swaps edges until the angles across from each are together at most 180 degrees; points stay",
                     "各稜線の向かいの角の和が 180 度以下になるまで交換する（頂点は動かない）"},
                    {.parameters = {parameter_row({"most_turn", "Largest bend", "最大の曲がり",
                                                   "edges whose faces bend by at least this stay",
                                                   "両側の面がこの角度以上に曲がる稜線は交換しない"},
                                                  {.kind = ParameterKind::angle, .initial = "10"}),
                                    seams_row("no seam of texture or normals is swapped, but weigh makes normals of "
                                              "flat faces anew, so that these are none; keep holds all seams; drop "
                                              "forgets texture and normals",
                                              "テクスチャと法線のシームは交換しない。weigh は平坦な面の法線を作り直し、"
                                              "その境目を交換できる。keep はすべてのシームを保つ。drop "
                                              "はテクスチャと法線を捨てる")},
                     .run = swap_to_delaunay,
                     .lineage = Lineage::told}),
      algorithm_row(
          {"unite_planar", "Unite planar regions", "平面領域の統合",
           "makes one polygon, with rings, of neighbouring faces that lie in one plane",
           "同じ平面上の隣り合う面を、リングを持つ一つの多角形にまとめる"},
          {.parameters = {parameter_row(
                              {"angle", "Angle", "角度", "by which normals may differ from that of the first face",
                               "最初の面の法線との差の上限"},
                              {.kind = ParameterKind::angle, .initial = "1"}),
                          parameter_row({"distance", "Distance", "距離", "by which points may leave its plane",
                                         "その平面からの距離の上限"},
                                        {.kind = ParameterKind::length, .initial = "0.01%"}),
                          parameter_row({"straight", "Corners on straight edges", "まっすぐな稜線上の角",
                                         "whether vertices with two edges stay where these are straight",
                                         "二本の稜線がまっすぐに続く頂点を残すか"},
                                        {.kind = ParameterKind::choice,
                                         .initial = "keep",
                                         .choices = {{"keep", "keep", "残す"}, {"drop", "drop", "取り除く"}}})},
           .run = unite_planar_regions})};
}

}  // namespace ryosen
