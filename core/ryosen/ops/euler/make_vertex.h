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

  static const OpInfo info;

  static MakeVertex at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh&) const { return {}; }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
  OpEffect apply(Edit& edit) const;
  bool operator==(const MakeVertex&) const = default;
};

}  // namespace ryosen
