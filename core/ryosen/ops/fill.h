// Fill: makes one face on a hole.
//
//        d-----c                d-----c
//        |     |                |  f  |       the face is left of the boundary halfedge a -> b
//        |     |       =>       |     |
//        a---->b                a---->b
//
// polygon list: the boundary cycle through a -> b becomes a face.
// needs: a boundary halfedge, on a cycle of three or more edges without a repeated point; no face on the same points;
//        no edge of the cycle has two faces on points. (make_loop also accepts cycles with bridges.)
// changes: F + 1, B - 1.
// inverse: delete_loop; delete if no edge was a wire.
#pragma once

#include "ryosen/ops/lines/on_element.h"

namespace ryosen {

struct Fill : OnHalfedge<Fill> {
  static constexpr OpInfo info{"fill",
                               "Fill hole",
                               "穴埋め",
                               "A-B",
                               "puts one face on the hole at a boundary edge",
                               "境界稜線 A-B の穴に一枚の面を張る",
                               '\0',
                               OpTargetKind::edge,
                               OpGroup::fill,
                               "",
                               Topology::may_change,
                               Subject::cycle,
                               OnSelection::each,
                               nullptr,
                               "",
                               nullptr,
                               false,
                               {"One face was made.", "# faces were made.", "面を # 個張りました。"}};

  // A boundary edge belongs to one hole, in whichever direction it is named.
  static Fill of_edge(const Mesh& mesh, Halfedge h);
  static Parsed<Fill> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static Fill at(const Mesh& mesh, const OpTarget& target);

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
