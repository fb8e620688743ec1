// The groups of operators, as a window lists them.
#pragma once

#include "core/base/enum_table.h"
#include "core/ops/op.h"

namespace ryosen {

struct OpGroupRow {
  OpGroup group;
  const char *en, *ja;
};
inline constexpr OpGroupRow op_groups[] = {
    {OpGroup::refine, "Refine", "細分"},
    {OpGroup::join, "Join and cut", "結合と切断"},
    {OpGroup::fill, "Delete and fill", "削除と穴埋め"},
    {OpGroup::orient, "Orient and reconnect", "向きと接続"},
    {OpGroup::euler, "Euler operators", "オイラー操作"},
};
static_assert(rows_are_in_order(op_groups, &OpGroupRow::group));

}  // namespace ryosen
