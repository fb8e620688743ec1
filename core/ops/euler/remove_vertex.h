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

#include "core/ops/op.h"

namespace ryosen {

struct RemoveVertex {
  Vertex vertex;

  static constexpr OpInfo info{"remove_vertex",
                               "Remove vertex",
                               "頂点消去",
                               "vN",
                               "removes an isolated vertex",
                               "孤立頂点を取り除く",
                               '\0',
                               OpTargetKind::vertex,
                               "kvs"};

  static Parsed<RemoveVertex> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static RemoveVertex at(const Mesh& mesh, const OpTarget& target);
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
