#include "ryosen/textbook/steps/all.h"

#include <array>

#include "ryosen/base/rows.h"
#include "ryosen/textbook/steps/players.h"

namespace ryosen::steps {

namespace {

constexpr std::array steps_rows{
    StepsRow{"script", "S", "script", "スクリプト", "the operators of a script, such as an exercise",
             "スクリプト（演習など）の操作を一つずつ", true, play_script, choices_of_script},
    StepsRow{"build", "", "build", "構築", "text 000's steps (1) to (10) from a list to halfedges, with text 003's map",
             "面のリストから半稜線を作る手順 (1)〜(10) とマップ", false, play_build, choices_of_build},
    StepsRow{"pair", "METHOD", "pairing", "対の探索",
             "how a method finds the pair of each halfedge: brute_force, vertex_lists, hash_16, hash, sparse_matrix",
             "半稜線の対を見つける：brute_force、vertex_lists、hash_16、hash、sparse_matrix", false, play_pair,
             choices_of_pair},
    StepsRow{"collapse", "A-B", "edge collapse", "稜線削除", "text 000's collapse line by line, beside the kernel's",
             "テキストの稜線削除を一行ずつ、カーネルの結果とともに", false, play_collapse, choices_of_collapse},
    StepsRow{"swap", "A-B", "edge swap", "稜線交換", "text 000's swap line by line, beside the kernel's",
             "テキストの稜線交換を一行ずつ、カーネルの結果とともに", false, play_swap, choices_of_swap},
    StepsRow{"split3", "H[,H...]", "edge split on 3i+j", "3i+j の辺細分",
             "text 003's split of halfedges by their numbers, with its map",
             "半稜線の番号での辺細分（テキスト 003）とそのマップ", false, play_split3, choices_of_split3},
    StepsRow{"walk", "V [FORM]", "one-ring", "1 近傍", "around a vertex, link by link, on a form of `ryosen forms`",
             "頂点の周りをリンクごとに（形状表現も選べる）", false, play_walk, choices_of_walk},
    StepsRow{"loop", "F [FORM]", "loop", "ループ", "around a face, link by link, on a form of `ryosen forms`",
             "面の周りをリンクごとに（形状表現も選べる）", false, play_loop, choices_of_loop},
    StepsRow{"relation", "R X", "relation", "関係",
             "one of the nine relations on each form, with the number of records read",
             "9 種類の関係を各形状表現で、読んだデータの数とともに", false, play_relation, choices_of_relation},
    StepsRow{
        "hull", "[ORDER [SEED]] [project=AXIS]", "convex hull", "凸包",
        "text 004's hull of the points, one by one: random, as_given or farthest; project: as seen along x, y, z, best",
        "テキスト 004 の凸包を一点ずつ（ORDER は random、as_given、farthest。project は x、y、z、best 方向の投影）",
        false, play_hull, choices_of_hull},
};

}  // namespace

std::span<const StepsRow> all_steps() { return steps_rows; }

const StepsRow* find_steps(std::string_view id) { return find_row(steps_rows, id); }

std::string call_of(const StepsRow& row) {
  std::string call(row.id);
  if (!row.syntax.empty()) call.append(" ").append(row.syntax);
  return call;
}

}  // namespace ryosen::steps
