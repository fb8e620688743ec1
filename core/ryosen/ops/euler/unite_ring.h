// Joins two loops of a face by a bridge.
//
//        o---------o                o---------o
//        |  o---o  |                |  o---o  |
//        |  |   |  |       =>       |  |   |  |
//        |  a---o  |                |  a---o  |
//        |         |                | /       |
//        b---------o                b---------o
//
// polygon list: the two loops become one list that traverses the bridge in both directions.
// needs: corners of different loops of one face, not joined by an edge.
// changes: E + 1, H - 1.
// inverse: make_ring.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct UniteRing {
  Halfedge into_a, into_b;  // the sides of the face that end at the two corners

  static constexpr OpInfo info{"unite_ring",
                               "Unite ring",
                               "リング結合",
                               "A B [fN] [P-A] [Q-B]",
                               "joins two loops of a face by a bridge",
                               "一つの面の二つのループを橋の稜線でつなぐ",
                               '\0',
                               OpTargetKind::selection,
                               OpGroup::euler,
                               "mekr",
                               Topology::kept,
                               Subject::edge,
                               OnSelection::all};

  static Parsed<UniteRing> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static UniteRing at(const Mesh&, const OpTarget&) { return {}; }
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
