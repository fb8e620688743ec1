#include "ryosen/algo/algorithm_rows.h"
#include "ryosen/algo/simplify/simplify.h"

namespace ryosen {

namespace {

constexpr std::string_view goals = "faces, ratio, error";

std::vector<ParameterRow> goal_parameters() {
  return {{.id = "faces",
           .kind = ParameterKind::count,
           .name_en = "Faces",
           .name_ja = "面の数",
           .help_en = "so many faces are left at most",
           .help_ja = "残す面の数の上限",
           .one_of = goals},
          {.id = "ratio",
           .kind = ParameterKind::ratio,
           .name_en = "Ratio",
           .name_ja = "比率",
           .help_en = "such a share of the faces is left at most, of the triangles where polygons are cut",
           .help_ja = "残す面の割合の上限（三角形分割する場合はその後の面に対する割合）",
           .one_of = goals},
          {.id = "error",
           .kind = ParameterKind::length,
           .name_en = "Error",
           .name_ja = "誤差",
           .help_en = "a vertex comes no farther from its planes as the root of the mean square; one may lie farther",
           .help_ja =
               "頂点と、それが代表する面の平面との距離（二乗平均平方根。平面の一つ一つはこれより遠いこともある）の上限",
           .one_of = goals},
          {.id = "relative",
           .kind = ParameterKind::flag,
           .name_en = "Relative",
           .name_ja = "相対値",
           .help_en = "the error is a share of the diagonal of the mesh's bounding box, as one with % is anyway",
           .help_ja = "誤差をメッシュの境界箱の対角線に対する割合とする（% 付きの値は常にそうなる）",
           .initial = "off"}};
}

std::vector<ParameterRow> limit_parameters() {
  return {
      {.id = "boundary",
       .kind = ParameterKind::choice,
       .name_en = "Boundary",
       .name_ja = "境界",
       .help_en = "weighted keeps its line, free does not, locked keeps its every vertex",
       .help_ja = "weighted は線を保ち、free は保たず、locked は頂点もすべて保つ",
       .initial = "weighted",
       .choices = {{"free", "Free", "自由"}, {"weighted", "Weighted", "重み付き"}, {"locked", "Locked", "固定"}}},
      {.id = "seams",
       .kind = ParameterKind::choice,
       .name_en = "Seams",
       .name_ja = "シーム",
       .help_en = "both keep seams of texture and smooth normals; keep also edges between normals of flat faces, which "
                  "smooth makes anew",
       .help_ja = "どちらもテクスチャと滑らかな法線のシームを保つ。keep は平坦な面の法線の境目も保ち、smooth "
                  "はそれらの法線を作り直す",
       .initial = "smooth",
       .choices = {{"smooth", "Smooth", "滑らか"}, {"keep", "Keep", "保つ"}}},
      {.id = "max_turn",
       .kind = ParameterKind::angle,
       .name_en = "Largest turn",
       .name_ja = "最大の回転",
       .help_en = "a collapse turns the normal of a face by less than this",
       .help_ja = "一度の稜線削除で面の法線が回る角度はこれより小さい",
       .initial = "90",
       .largest = 90,
       .excludes_smallest = true},
      {.id = "min_angle",
       .kind = ParameterKind::angle,
       .name_en = "Smallest angle",
       .name_ja = "最小の角",
       .help_en = "no triangle gets a smaller angle, or one smaller than it has where that is less",
       .help_ja = "三角形の角をこれより小さくしない（もとから小さい角は、さらに小さくしない）",
       .initial = "0",
       .largest = 60},
      {.id = "select",
       .kind = ParameterKind::elements,
       .name_en = "Only these",
       .name_ja = "対象",
       .help_en = "only vertices of these elements change; else all",
       .help_ja = "これらの要素の頂点だけを変える（省くとすべて）",
       .is_worked_on = true},
      {.id = "lock",
       .kind = ParameterKind::elements,
       .name_en = "Locked",
       .name_ja = "固定",
       .help_en = "vertices of these elements stay where they are",
       .help_ja = "これらの要素の頂点を動かさない"}};
}

std::vector<ParameterRow> way_parameters() {
  return {{.id = "triangulate",
           .kind = ParameterKind::flag,
           .name_en = "Triangulate",
           .name_ja = "三角形分割",
           .help_en = "polygons are cut into triangles first",
           .help_ja = "先に多角形を三角形に分割する",
           .initial = "off"},
          {.id = "remove_small",
           .kind = ParameterKind::flag,
           .name_en = "Remove small parts",
           .name_ja = "小さな部分の削除",
           .help_en = "parts smaller than the error go, where the goal is not reached otherwise",
           .help_ja = "目標に達しないとき、誤差より小さい部分を丸ごと取り除く",
           .initial = "off"},
          {.id = "no_self_intersections",
           .kind = ParameterKind::flag,
           .name_en = "No self-intersections",
           .name_ja = "自己交差の防止",
           .help_en = "faces of a mesh of triangles that does not meet itself do not come to meet",
           .help_ja = "自己交差のない三角形メッシュで、面を新たに交わらせない",
           .initial = "off"},
          {.id = "effort",
           .kind = ParameterKind::count,
           .name_en = "Effort",
           .name_ja = "手間",
           .help_en = "more takes longer and loses less; 2 also swaps edges where the surface comes nearer",
           .help_ja = "大きいほど時間がかかり、誤差が小さい（2 では近づく箇所の稜線交換もする）",
           .initial = "1",
           .largest = 2}};
}

}  // namespace

std::vector<AlgorithmRow> simplify_rows() {
  std::vector<ParameterRow> parameters = goal_parameters();
  for (const std::vector<ParameterRow>& more : {limit_parameters(), way_parameters()})
    parameters.insert(parameters.end(), more.begin(), more.end());
  return {{.id = "simplify",
           .name_en = "Simplify",
           .name_ja = "簡略化",
           .help_en = "takes faces away while the surface stays nearly the same",
           .help_ja = "形をほとんど変えずに面を減らす",
           .parameters = std::move(parameters),
           .keeps_geometry = false,
           .solves = {},
           .run = simplify,
           .lineage = Lineage::told,
           .has_goal = true,
           .accounts_for_edges = true}};
}

}  // namespace ryosen
