// The groups of operators, as a window lists them.
#pragma once

#include "ryosen/base/enum_table.h"
#include "ryosen/ops/op.h"

namespace ryosen {

struct OpGroupRow {
  OpGroup group;
  const char *en, *ja;
  const char *help_en, *help_ja;  // what its operators are for, in a sentence
  bool is_apart = false;          // a menu with operators of several groups has one of its own for these
};
inline constexpr OpGroupRow op_groups[] = {
    {OpGroup::refine, "Refine", "細分", "Put in vertices and edges.", "頂点や稜線を加えます。"},
    {OpGroup::join, "Join and cut", "結合と切断", "Make one of several elements, or several of one.",
     "いくつかの要素を一つにしたり、一つを分けたりします。"},
    {OpGroup::fill, "Delete and fill", "削除と穴埋め", "Take elements away, or put faces into holes.",
     "要素を取り除いたり、穴に面を張ったりします。"},
    {OpGroup::orient, "Orient and reconnect", "向きと接続", "Turn faces over, weld and detach.",
     "面を裏返したり、頂点をつないだり離したりします。"},
    {OpGroup::euler, "Euler operators", "オイラー操作",
     "Single steps that keep V − E + F + B − H = 2(S − G), by which any mesh can be built.",
     "V − E + F + B − H = 2(S − G) を保つ一歩ずつの操作で、どんなメッシュも作れます。", true},
};
static_assert(rows_are_in_order(op_groups, &OpGroupRow::group));

}  // namespace ryosen
