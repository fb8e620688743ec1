#include "core/base/reasons.h"

#include <array>
#include <cstddef>

#include "core/base/enum_table.h"

namespace ryosen {

namespace {

constexpr auto refuse = RuleSeverity::refuse;
constexpr auto warn = RuleSeverity::warn;

constexpr std::array rules{
    RuleText{Rule::deleted, "deleted", refuse, "", "The element has been deleted.", "要素はすでに削除されています。",
             "undo brings it back", "元に戻すと復活します"},
    RuleText{
        Rule::copies, "copies", refuse, "collapse swap make_loop unite_loop unite_edge fill dissolve vertex_split",
        "A non-manifold or misoriented place would change, where a point lies on several sheets or fans of faces.",
        "非多様体または向きの不一致な場所が変わります。そこでは一つの点に複数のシートまたは面の扇が集まっています。",
        "orient the faces, or split the edges that lead there", "面の向きを揃えるか、そこへ至る稜線を細分します"},
    RuleText{Rule::isolated_apex, "isolated_apex", refuse, "collapse",
             "The vertex opposite the edge belongs to this triangle alone and would be left without a face.",
             "稜線の向かいの頂点はこの三角形だけに属し、面を失って孤立します。", "split one of its two other edges",
             "その頂点の他の稜線を細分します"},
    RuleText{Rule::vanishes, "vanishes", refuse, "collapse",
             "Both triangles at the edge have the same third vertex; nothing would be left of them.",
             "稜線の両側の三角形が同じ第3の頂点を持ち、何も残りません。", "split the edge to the third vertex",
             "第3の頂点への稜線を細分します"},
    RuleText{Rule::closes_hole, "closes_hole", refuse, "collapse",
             "The edge bounds a hole of three edges, which would close and change the topology.",
             "稜線は稜線三本の穴の縁にあり、削除すると穴が閉じて位相が変わります。", "split another edge of the hole",
             "穴の他の稜線を細分します"},
    RuleText{
        Rule::common_neighbour, "common_neighbour", refuse, "collapse weld",
        "The two points have a neighbour in common, and not as the apex of a triangle at an edge between them; two "
        "edges would fall together.",
        "二点に、その間の稜線に接する三角形の頂点ではない共通の隣接頂点があり、二本の稜線が重なります。",
        "split the edge to the common neighbour", "共通の隣接頂点への稜線を細分します"},
    RuleText{Rule::common_face, "common_face", refuse, "collapse weld",
             "A face holds both points that would become one; it would visit one vertex twice.",
             "一つになる二点をともに含む面があり、その面は同じ頂点を二度通ることになります。",
             "divide that face between the two; neighbouring corners become one only by collapse",
             "その二点の間で面を分割します。隣り合う角は collapse でのみ一つになります"},
    RuleText{
        Rule::inner_edge, "inner_edge", refuse, "collapse",
        "The edge runs through the inside between two boundary vertices; the surface would be pinched to one point.",
        "稜線は内部を通って二つの境界頂点を結び、曲面が一点にくびれます。",
        "fill the hole at one end, or split the edge and collapse one half",
        "片端の穴を埋めるか、稜線を細分してその半分を削除します"},
    RuleText{Rule::duplicate_face, "duplicate_face", refuse,
             "collapse swap make_loop separate_loop unite_loop unite_edge make_face fill weld dissolve",
             "Two faces would have the same vertices (a hanging pair when they lie back to back).",
             "二つの面が同じ頂点を持つことになります（背中合わせなら縮退）。", "split an edge of one of the two faces",
             "どちらかの面の稜線を細分します"},
    RuleText{Rule::boundary, "boundary", refuse, "swap unite_loop dissolve", "The edge has a face on one side only.",
             "稜線の片側にしか面がありません。", "put a face on its other side: fill, make_face",
             "反対側に面を張ります（fill、make_face）"},
    RuleText{Rule::edge_exists, "edge_exists", refuse,
             "swap make_edge separate_loop unite_edge unite_ring weld triangulate dissolve",
             "The new edge exists already.", "新しい稜線がすでに存在します。", "split the edge that exists",
             "既存の稜線を細分します"},
    RuleText{Rule::corner_twice, "corner_twice", refuse, "swap make_face fill", "A face would visit one vertex twice.",
             "面が同じ頂点を二度通ることになります。", "split one of the edges the faces share",
             "面が共有する稜線を細分します"},
    RuleText{Rule::loses_duplicate, "loses_duplicate", refuse,
             "swap separate_loop unite_loop poke vertex_split triangulate dissolve extrude",
             "One of the faces has a duplicate on the same vertices, and the two would come apart.",
             "一方の面に同じ頂点を持つ重複面があり、両者が食い違います。",
             "delete the duplicate by delete_loop, or detach it",
             "delete_loop で重複面を取り除くか、detach で切り離します"},
    RuleText{Rule::same_apex, "same_apex", refuse, "split",
             "Two triangles that would be cut have the same third vertex; the new edges would fall together.",
             "切られる二つの三角形が同じ第3の頂点を持ち、新しい稜線が重なります。", "delete one of the two triangles",
             "どちらかの三角形を削除します"},
    RuleText{Rule::oriented, "oriented", refuse, "orient", "Turning faces would not make fewer neighbours disagree.",
             "面を裏返しても、向きの揃わない隣り合う面はこれ以上減りません。", "nothing to do",
             "何もする必要がありません"},
    RuleText{Rule::has_edges, "has_edges", refuse, "remove_vertex", "Edges end at the vertex.",
             "頂点に稜線がつながっています。", "delete its faces and edges first", "先に面と稜線を取り除きます"},
    RuleText{Rule::has_face, "has_face", refuse, "delete_edge make_loop make_face fill weld",
             "A face lies at this side of the edge.", "稜線のこの側に面があります。", "delete the face first",
             "先に面を取り除きます"},
    RuleText{Rule::same_vertex, "same_vertex", refuse, "make_edge separate_loop unite_ring weld vertex_split",
             "What must be two points is one and the same.", "二つの別々の点であるべきものが、同じ一点です。",
             "choose two different points", "異なる二点を選びます"},
    RuleText{Rule::no_gap, "no_gap", refuse, "make_edge make_face weld vertex_split",
             "The vertex has no gap there: faces lie all around it.",
             "頂点のその場所には隙間がなく、面に囲まれています。", "delete a face at it, or divide one",
             "接する面を取り除くか、面を分割します"},
    RuleText{Rule::loop, "loop", refuse,
             "make_loop separate_loop unite_loop separate_edge unite_edge collapse swap split make_face fill dissolve "
             "vertex_split",
             "A face would not come apart, bridges taken out, into simple loops of three or more corners that share no "
             "vertex.",
             "面が、橋を除いても、頂点を共有しない三角以上の単純なループに分かれません。",
             "choose corners of one simple loop", "単純な一つのループになるように選びます"},
    RuleText{Rule::two_edges, "two_edges", refuse, "unite_edge", "The vertex does not have exactly two edges.",
             "頂点の稜線がちょうど二本ではありません。", "never: dissolve the vertex instead",
             "不可能です。代わりに頂点を溶解します"},
    RuleText{Rule::no_bridge, "no_bridge", refuse, "make_ring",
             "The edge is no bridge: not one and the same face lies on both of its sides.",
             "稜線は橋ではありません。両側が同じ一つの面ではありません。",
             "never: only an edge with one face on both sides is one", "不可能です。両側が同じ面の稜線だけが橋です"},
    RuleText{Rule::same_loop, "same_loop", refuse, "unite_ring", "Both corners lie on one loop of the face.",
             "二つの角が面の同じループ上にあります。", "never: divide the face between them instead",
             "不可能です。代わりにその間で面を分割します"},
    RuleText{Rule::different_loops, "different_loops", refuse, "separate_loop",
             "The corners lie on different loops of the face; an edge between them would be a bridge.",
             "二つの角は面の異なるループ上にあり、間の稜線は橋になります。", "join the loops by unite_ring",
             "unite_ring でループをつなぎます"},
    RuleText{Rule::different_faces, "different_faces", refuse, "separate_loop unite_ring", "No face has both corners.",
             "両方の角を持つ面がありません。", "unite the faces between them first", "先に間の面をまとめます"},
    RuleText{Rule::same_face, "same_face", refuse, "unite_loop dissolve",
             "One face lies on both sides of the edge: it is a bridge.", "稜線の両側が同じ面で、橋になっています。",
             "never: take it away by make_ring instead", "不可能です。代わりに make_ring で取り除きます"},
    RuleText{Rule::one_fan, "one_fan", refuse, "separate_fans", "No vertex of the point has several fans of faces.",
             "この点には複数の面の扇を持つ頂点がありません。", "never: to make copies different points detach a face",
             "不可能です。複製を別の点にするには面を切り離します"},
    RuleText{Rule::detached, "detached", refuse, "detach", "The faces touch no other face.",
             "面は他のどの面にも接していません。", "nothing to do", "何もする必要がありません"},
    RuleText{Rule::wire, "wire", refuse, "weld vertex_split", "The edge has no face.", "稜線に面がありません。",
             "put a face on it first, or weld its ends", "先に面を張るか、両端の頂点を縫合します"},
    RuleText{Rule::same_edge, "same_edge", refuse, "weld", "Both names mean the same edge.",
             "二つの名前が同じ稜線を指しています。", "choose two different edges", "異なる二本の稜線を選びます"},
    RuleText{Rule::has_rings, "has_rings", refuse, "poke", "The face has rings or bridges.",
             "面に内側のループまたは橋があります。", "triangulate the face, or divide it until it has no ring",
             "面を三角形に分割するか、内側のループがなくなるまで分割します"},
    RuleText{Rule::triangulated, "triangulated", refuse, "triangulate", "There are only triangles already.",
             "すでに三角形だけです。", "nothing to do", "何もする必要がありません"},
    RuleText{Rule::nothing_between, "nothing_between", refuse, "dissolve",
             "No two faces meet at an edge of the vertex.", "頂点の稜線を挟んで隣り合う二つの面がありません。",
             "never: delete the vertex instead", "不可能です。代わりに頂点を削除します"},
    RuleText{Rule::joins_fans, "joins_fans", refuse, "collapse",
             "Faces hang on both ends of the wire; two fans would meet at one vertex.",
             "面を持たない稜線の両端に面があり、二つの扇が一つの頂点で接することになります。",
             "never: the vertex would be non-manifold", "不可能です。頂点が非多様体になります"},
    RuleText{Rule::lone_edge, "lone_edge", refuse, "collapse",
             "The edge stands alone; nothing but a free vertex would be left.",
             "稜線が孤立しており、孤立頂点だけが残ります。", "join another edge to it", "別の稜線をつなぎます"},
    RuleText{Rule::pinch, "pinch", warn, "make_face make_loop fill weld detach delete delete_loop",
             "More fans of faces would meet at a point than before: the surface is pinched there.",
             "一つの点に集まる面の扇が増え、面はそこで点だけでつながります。",
             "detach one of the fans, or put a face between them", "一方の扇を切り離すか、間に面を張ります"},
    RuleText{
        Rule::normal_turns, "normal_turns", warn,
        "collapse swap split move_vertex separate_loop poke vertex_split triangulate unite_loop unite_edge dissolve "
        "weld",
        "The normal of a face turns by 90 degrees or more.", "面の法線が90度以上変わります。",
        "choose another position", "別の位置を選びます"},
    RuleText{
        Rule::degenerate, "degenerate", warn,
        "collapse swap split move_vertex make_loop make_face fill separate_loop poke vertex_split triangulate extrude "
        "unite_edge dissolve weld",
        "A face becomes degenerate: its corners lie on a line.", "角が一直線に並び、面積ゼロの面になります。",
        "choose another position", "別の位置を選びます"},
    RuleText{Rule::seam, "seam", warn, "collapse swap unite_loop dissolve",
             "The edge is a seam: corner values differ between its two sides.",
             "稜線は継ぎ目で、両側の角の値が異なります。", "choose an edge that is no seam",
             "継ぎ目でない稜線を選びます"},
    RuleText{Rule::intersects, "intersects", warn, "", "A face would cut through a face nearby.",
             "面が近くの面と交差します。", "choose another position", "別の位置を選びます"},
    RuleText{Rule::outside_edge, "outside_edge", warn, "split separate_edge",
             "The new vertex would not lie between the ends of the edge.", "新しい頂点が稜線の両端の間にありません。",
             "choose a number between 0 and 1", "0 と 1 の間の数を選びます"},
    RuleText{Rule::same_place, "same_place", warn, "", "Two vertices would lie at one place.",
             "二つの頂点が同じ位置に重なります。", "choose another position, or weld the two",
             "別の位置を選ぶか、二つを縫合します"},
    RuleText{Rule::leaves_face, "leaves_face", warn, "",
             "An edge would leave the area of its face: it crosses a ring or another edge of the face.",
             "稜線が面の外に出て、面の穴または他の稜線と交わります。", "choose other corners or another position",
             "別の角または別の位置を選びます"},
};

static_assert(rows_are_in_order(rules, &RuleText::rule));

}  // namespace

std::span<const RuleText> rule_table() { return rules; }

const RuleText& text_of(Rule rule) { return rules[static_cast<std::size_t>(rule)]; }

}  // namespace ryosen
