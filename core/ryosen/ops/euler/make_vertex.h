// Makes an isolated vertex.
//
//                          v
//        (empty)   =>      o
//
// polygon list: a new vertex without a face.
// needs: nothing.
// changes: V + 1, B + 1, S + 1.
// inverse: remove_vertex.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct MakeVertex {
  glm::dvec3 position{0.0};

  static constexpr OpInfo info{"make_vertex",
                               "Make vertex",
                               "頂点生成",
                               "X,Y,Z",
                               "makes an isolated vertex at a position",
                               "指定した位置に孤立頂点を置く",
                               '\0',
                               OpTargetKind::none,
                               OpGroup::euler,
                               "mvs",
                               Topology::may_change,
                               Subject::edge,
                               OnSelection::none};

  static Parsed<MakeVertex> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static MakeVertex at(const Mesh&, const OpTarget&) { return {}; }
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh&) const { return {}; }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
