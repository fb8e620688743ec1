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

  static const OpInfo info;

  static UniteRing at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
  bool operator==(const UniteRing&) const = default;
};

}  // namespace ryosen
