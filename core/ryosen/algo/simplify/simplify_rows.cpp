#include "ryosen/algo/algorithm_rows.h"
#include "ryosen/algo/seams/seam_mode.h"
#include "ryosen/algo/simplify/simplify.h"

namespace ryosen {

namespace {

constexpr std::string_view goals = "faces, ratio, error, max_distance";

std::vector<ParameterRow> simplify_parameters() {
  return {
      parameter_row({"faces", "Faces", "面の数", "so many faces are left at most", "残す面の数の上限"},
                    {.kind = ParameterKind::count, .one_of = goals}),
      parameter_row({"ratio", "Ratio", "比率",
                     "such a share of the faces is left at most, of the triangles where polygons are cut",
                     "残す面の割合の上限（三角形分割する場合はその後の面に対する割合）"},
                    {.kind = ParameterKind::ratio, .one_of = goals}),
      parameter_row(
          {"error", "Error", "誤差",
           "a vertex comes no farther from its planes as the root of the mean square; one may lie farther",
           "頂点と、それが代表する面の平面との距離（二乗平均平方根。平面の一つ一つはこれより遠いこともある）の上限"},
          {.kind = ParameterKind::length, .one_of = goals}),
      parameter_row(
          {"max_distance", "Largest distance", "最大の距離",
           "proves that no point of either surface is farther than this from the other; triangles only, small parts "
           "are kept",
           "結果と入力のどちらの面のどの点も、他方の面からこれより遠くないことを証明する（三角形のみ。小さな部分は残"
           "す）"},
          {.kind = ParameterKind::length, .one_of = goals}),
      parameter_row({"relative", "Relative", "相対値",
                     "error and distance are shares of the diagonal of the mesh's bounding box, as with % anyway",
                     "誤差と距離をメッシュの境界箱の対角線に対する割合とする（% 付きの値は常にそうなる）"},
                    {.kind = ParameterKind::flag, .initial = "off"}),
      parameter_row(
          {"boundary", "Boundary", "境界", "weighted keeps its line, free does not, locked keeps its every vertex",
           "weighted は線を保ち、free は保たず、locked は頂点もすべて保つ"},
          {.kind = ParameterKind::choice,
           .initial = "weighted",
           .choices = {{"free", "Free", "自由"}, {"weighted", "Weighted", "重み付き"}, {"locked", "Locked", "固定"}}}),
      seams_row(
          "weigh moves seams of texture and normals where that costs least, and makes normals of flat faces anew; "
          "keep holds all seams; drop forgets texture and normals",
          "weigh はテクスチャと法線のシームを損失の少ない所だけ動かし、平坦な面の法線を作り直す。keep "
          "はすべてのシームを保つ。drop はテクスチャと法線を捨てる"),
      parameter_row(
          {"max_turn", "Largest turn", "最大の回転", "a collapse turns the normal of a face by less than this",
           "一度の稜線削除で面の法線が回る角度はこれより小さい"},
          {.kind = ParameterKind::angle, .initial = "90", .largest = 90, .excludes_smallest = true}),
      parameter_row({"min_angle", "Smallest angle", "最小の角",
                     "no triangle gets a smaller angle, or one smaller than it has where that is less",
                     "三角形の角をこれより小さくしない（もとから小さい角は、さらに小さくしない）"},
                    {.kind = ParameterKind::angle, .initial = "0", .largest = 60}),
      parameter_row(
          {"colour_weight", "Colour weight", "色の重み",
           "more keeps colours and texture better and the shape less: with 1 a change of a colour from 0 to 1 "
           "counts as much as a distance of 2 % of the mesh's longest side, and a shift of the texture as much "
           "as a distance as long; 0 leaves both out",
           "大きいほど色とテクスチャを保ち、形の誤差が増える（1 では色の 0 から 1 "
           "への変化をメッシュの最大寸法の 2 % の距離と、テクスチャのずれを同じ長さの距離と同等に数える。0 "
           "では数えない）"},
          {.kind = ParameterKind::number, .initial = "0.005", .smallest = 0, .largest = 100}),
      parameter_row({"select", "Only these", "対象", "only vertices of these elements change; else all",
                     "これらの要素の頂点だけを変える（省くとすべて）"},
                    {.kind = ParameterKind::elements, .is_worked_on = true}),
      parameter_row({"lock", "Locked", "固定", "vertices of these elements stay where they are",
                     "これらの要素の頂点を動かさない"},
                    {.kind = ParameterKind::elements}),
      parameter_row({"triangulate", "Triangulate", "三角形分割", "polygons are cut into triangles first",
                     "先に多角形を三角形に分割する"},
                    {.kind = ParameterKind::flag, .initial = "off"}),
      parameter_row({"remove_small", "Remove small parts", "小さな部分の削除",
                     "parts smaller than the error go, where the goal is not reached otherwise",
                     "目標に達しないとき、誤差より小さい部分を丸ごと取り除く"},
                    {.kind = ParameterKind::flag, .initial = "off"}),
      parameter_row({"no_self_intersections", "No self-intersections", "自己交差の防止",
                     "faces of a mesh of triangles do not come to meet; pairs that already do, or take their place, "
                     "never become more",
                     "三角形メッシュの面を新たに交わらせない（もとから交わる組は隣の面に移ることはあるが、増えない）"},
                    {.kind = ParameterKind::flag, .initial = "off"}),
      parameter_row({"topology", "Topology", "位相",
                     "keep leaves handles and parts as they are; change closes handles and joins parts where no edge "
                     "can collapse, "
                     "the smallest and nearest first",
                     "keep はハンドルと部分をそのまま残す。change "
                     "は稜線削除できなくなったとき、小さいハンドルを閉じ、近い部分をつなぐ"},
                    {.kind = ParameterKind::choice,
                     .initial = "keep",
                     .choices = {{"keep", "Keep", "保つ"}, {"change", "Change", "変える"}}}),
      parameter_row(
          {"force", "Force", "強制",
           "goes on to the number of faces where that loses the shape: where any collapse costs more than 5 % "
           "of the diagonal and 3 times as much as at twice as many faces, draws a boundary out, or most edges are "
           "misoriented",
           "形が崩れても指定の面数まで続ける（どの稜線削除の誤差も対角線の 5 % を超え、面が倍あったときの"
           " 3 倍を超えるとき、境界が広がるとき、または稜線の過半数の向きが合わないとき）"},
          {.kind = ParameterKind::flag, .initial = "off"}),
      parameter_row(
          {"effort", "Effort", "手間",
           "more takes longer and loses less: 1 also moves vertices to where the surface comes nearer, 2 also swaps "
           "edges for that, and takes what 1 makes where that is nearer",
           "大きいほど時間がかかり、誤差が小さい（1 では面が近づく位置へ頂点も動かす。2 "
           "では近づく箇所の稜線交換もし、1 の結果の方が近ければそれを採る）"},
          {.kind = ParameterKind::count, .initial = "1", .largest = 2})};
}

}  // namespace

std::vector<AlgorithmRow> simplify_rows() {
  return {algorithm_row({"simplify", "Simplify", "簡略化", "takes faces away while the surface stays nearly the same",
                         "形をほとんど変えずに面を減らす"},
                        {.parameters = simplify_parameters(),
                         .run = simplify,
                         .lineage = Lineage::told,
                         .has_goal = true,
                         .accounts_for_edges = true})};
}

}  // namespace ryosen
