// The sorts of elements that the pointer can pick: what the command `mode` calls them, and what is said where there is
// none under the pointer.
#pragma once

#include <string_view>

#include "ryosen/base/enum_table.h"
#include "ryosen/scene/pick/picker.h"

namespace ryosen {

struct PickModeRow {
  PickMode mode;
  Element::Kind kind;  // that it picks
  std::string_view id;
  std::string_view point_en, point_ja;
  std::string_view help_en, help_ja;  // what such an element is, in a sentence
};
inline constexpr PickModeRow pick_modes[] = {
    {PickMode::vertex, Element::Kind::vertex, "vertex", "Point at a vertex.", "頂点を指してください。",
     "A vertex is a corner point of the mesh.", "頂点はメッシュの角の点です。"},
    {PickMode::edge, Element::Kind::edge, "edge", "Point at an edge.", "稜線を指してください。",
     "An edge is the line between two vertices at which faces meet.",
     "稜線は二つの頂点を結び、面どうしが接する線です。"},
    {PickMode::face, Element::Kind::face, "face", "Point at a face.", "面を指してください。",
     "A face is a polygon of three or more corners.", "面は三つ以上の角をもつ多角形です。"},
    {PickMode::halfedge, Element::Kind::halfedge, "halfedge", "Point at a halfedge.", "半稜線を指してください。",
     "A halfedge is one side of an edge, directed along the face that it belongs to.",
     "半稜線は稜線の片側で、属する面に沿った向きをもちます。"}};
static_assert(rows_are_in_order(pick_modes, &PickModeRow::mode));

}  // namespace ryosen
