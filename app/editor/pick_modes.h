// The sorts of elements that the pointer can pick: what the command `mode` calls them, and what is said where there is none
// under the pointer.
#pragma once

#include <string_view>

#include "core/base/enum_table.h"
#include "core/pick/picker.h"

namespace ryosen {

struct PickModeRow {
  PickMode mode;
  std::string_view id;
  std::string_view point_en, point_ja;
};
inline constexpr PickModeRow pick_modes[] = {
    {PickMode::vertex, "vertex", "Point at a vertex.", "頂点を指してください。"},
    {PickMode::edge, "edge", "Point at an edge.", "稜線を指してください。"},
    {PickMode::face, "face", "Point at a face.", "面を指してください。"},
    {PickMode::halfedge, "halfedge", "Point at a halfedge.", "半稜線を指してください。"}};
static_assert(rows_are_in_order(pick_modes, &PickModeRow::mode));

}  // namespace ryosen
