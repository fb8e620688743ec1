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

#include "ryosen/ops/lines/on_element.h"

namespace ryosen {

struct RemoveVertex : OnVertex<RemoveVertex> {
  static constexpr OpInfo info{
      "remove_vertex",      "Remove vertex", "頂点消去", "vN", "removes an isolated vertex", "孤立頂点を取り除く", '\0',
      OpTargetKind::vertex, OpGroup::euler,  "kvs"};

  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
