// Removes an isolated vertex.
//
//        v
//        o       =>      (empty)
//
// polygon list: the vertex is removed.
// needs: a vertex without edges.
// changes: V - 1, B - 1, S - 1.
// inverse: make_vertex.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct RemoveVertex : OnVertex<RemoveVertex> {
  static const OpInfo info;

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
