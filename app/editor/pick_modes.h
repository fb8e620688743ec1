// What the command `mode` calls the sorts of elements that the pointer can pick.
#pragma once

#include <string_view>

#include "core/base/enum_table.h"
#include "core/pick/picker.h"

namespace ryosen {

struct PickModeRow {
  PickMode mode;
  std::string_view id;
};
inline constexpr PickModeRow pick_modes[] = {
    {PickMode::vertex, "vertex"}, {PickMode::edge, "edge"}, {PickMode::face, "face"}, {PickMode::halfedge, "halfedge"}};
static_assert(rows_are_in_order(pick_modes, &PickModeRow::mode));

}  // namespace ryosen
