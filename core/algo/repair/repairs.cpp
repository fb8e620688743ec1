#include "core/algo/repair/repairs.h"

#include "core/algo/proposals.h"
#include "core/algo/repair/detach_nonmanifold.h"
#include "core/algo/repair/fill_holes.h"
#include "core/algo/repair/give_places.h"
#include "core/algo/repair/orient_faces.h"
#include "core/algo/repair/remove_degenerate.h"
#include "core/algo/repair/remove_faces.h"
#include "core/algo/repair/weld_points.h"
#include "core/base/count_text.h"

namespace ryosen {

namespace {

AlgorithmResult drop_quarantined(Edit&, const AlgorithmInput& input, Progress&) {
  return {input.quarantined, 0,
          count_text(input.quarantined, "One quarantined face was dropped.", "# quarantined faces were dropped.",
                     "隔離された面を # 個捨てました。"),
          input.quarantined > 0};
}

}  // namespace

std::vector<AlgorithmRow> repair_rows() {
  using Kind = ProblemKind;
  return {
      {"give_places",
       "Give vertices a place",
       "座標のない頂点の配置",
       "vertices without a place are put in the middle of their neighbours; where none has one, faces go with them",
       "座標が有限でない頂点を隣の頂点の平均の位置に置く（隣にも座標がなければ面ごと削除する）",
       {},
       true,
       {Kind::nonfinite_vertex},
       give_places},
      {"remove_duplicates",
       "Remove duplicate faces",
       "重複面の削除",
       "of faces on the same loop of points one stays, and both walls between closed parts",
       "同じ点の並びを持つ面は一つだけを残す（閉じた部分どうしの壁は両方残す）",
       {},
       true,
       {Kind::duplicate_face, Kind::hanging_pair},
       remove_duplicate_faces},
      {"weld_equal",
       "Weld equal points",
       "同じ位置の点の縫合",
       "points at one place become one, where the surface stays sound",
       "同じ位置の点を、曲面が健全なまま保たれる限り一つにする",
       {},
       true,
       {Kind::boundary_loop},
       weld_equal_points},
      {"orient",
       "Orient faces",
       "面の向きを揃える",
       "turns faces so that fewer neighbours disagree, none where possible",
       "隣り合う面の向きの不一致が減るように、可能ならなくなるように面を裏返す",
       {},
       true,
       {Kind::misoriented_edge},
       orient_faces},
      {"detach_nonmanifold",
       "Detach at non-manifold places",
       "非多様体部分の切り離し",
       "solids that share faces, edges or points come apart closed; so does each other fan of faces",
       "面・稜線・点を共有する立体を閉じたまま分け、ほかの面も扇ごとに別の点に分ける",
       {},
       true,
       {Kind::nonmanifold_edge, Kind::nonmanifold_vertex},
       detach_nonmanifold},
      {"weld_close",
       "Weld close points",
       "近い点の縫合",
       "points no farther apart than the distance become one",
       "指定した距離以内の点を一つにする",
       {{.id = "distance",
         .kind = ParameterKind::length,
         .name_en = "Distance",
         .name_ja = "距離",
         .help_en = "how far apart they may be",
         .help_ja = "点どうしの最大の距離",
         .is_required = true,
         .proposed = hundredth_of_mean_edge_length_text}},
       false,
       {Kind::boundary_loop, Kind::degenerate_area},
       weld_close_points},
      {"remove_degenerate",
       "Remove faces without area",
       "面積ゼロの面の削除",
       "collapses, swaps or unites them away, else deletes them",
       "稜線削除・稜線交換・隣の面への統合で取り除き、できなければ面を削除する",
       {},
       false,
       {Kind::degenerate_area},
       remove_degenerate_faces},
      {"fill_holes",
       "Fill holes",
       "穴埋め",
       "closes boundary loops by fine, smooth patches",
       "境界ループを滑らかな面でふさぐ",
       {{.id = "most_edges",
         .kind = ParameterKind::count,
         .name_en = "Most edges",
         .name_ja = "最大の稜線数",
         .help_en = "longer loops are left open",
         .help_ja = "これより長いループは残す"}},
       false,
       {Kind::boundary_loop},
       fill_holes},
      {"remove_isolated",
       "Remove isolated vertices",
       "孤立頂点の削除",
       "deletes vertices that belong to nothing",
       "どこにも属さない頂点を削除する",
       {},
       false,
       {Kind::isolated_vertex},
       remove_isolated_vertices},
      {"drop_quarantined",
       "Drop quarantined faces",
       "隔離された面の破棄",
       "forgets the faces of the file that cannot be connected",
       "接続できず隔離されたファイル中の面を捨てる",
       {},
       false,
       {Kind::quarantined_face, Kind::degenerate_repeat},
       drop_quarantined},
  };
}

}  // namespace ryosen
