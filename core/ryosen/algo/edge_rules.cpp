#include "ryosen/algo/edge_rules.h"

namespace ryosen {

namespace {

constexpr EdgeRuleRow edge_rule_rows[] = {
    {EdgeRule::structure, "structure", "Structure", "構造", "The mesh would no longer be sound.",
     "メッシュの構造が壊れる。"},
    {EdgeRule::seam, "seam", "Seam", "シーム", "It would move a seam of texture or normals that is to stay.",
     "固定されたシーム（テクスチャや法線の境目）が動く。"},
    {EdgeRule::boundary, "boundary", "Boundary", "境界", "It would move a boundary that is to stay.",
     "固定された境界が動く。"},
    {EdgeRule::normal, "normal", "Normal", "法線", "A face would turn too far.", "面の向きが変わりすぎる。"},
    {EdgeRule::angle, "angle", "Angle", "角", "A face would get too small an angle.", "面の角が小さくなりすぎる。"},
    {EdgeRule::error, "error", "Error", "誤差", "The surface would move farther than is allowed.",
     "許容誤差を超える。"},
    {EdgeRule::selection, "selection", "Selection", "選択", "It is not among the elements that may change.",
     "変更できる要素に含まれない。"},
    {EdgeRule::self_intersection, "self_intersection", "Self-intersection", "自己交差",
     "Faces would meet that did not.", "面が新たに交わる。"},
    {EdgeRule::distance, "distance", "Distance", "距離",
     "The surface might come farther from the input than is allowed.", "入力からの距離が上限を超えるおそれがある。"},
    {EdgeRule::free, "free", "Free", "制約なし", "Nothing holds it: the goal was reached before.",
     "制約なし（先に目標に達した）。"},
};
static_assert(rows_are_in_order(edge_rule_rows, &EdgeRuleRow::rule));

}  // namespace

std::span<const EdgeRuleRow> edge_rule_table() { return edge_rule_rows; }

}  // namespace ryosen
