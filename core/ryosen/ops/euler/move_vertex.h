// Moves a point; all its copies move along.
//
//        v
//        o           =>              o v
//       /|\                     --- /|
//
// polygon list: only the position changes.
// needs: a live vertex.
// changes: no counts.
// inverse: moving back.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct MoveVertex {
  Vertex vertex;
  glm::dvec3 position{0.0};

  static const OpInfo info;

  static MoveVertex at(const Mesh& mesh, const OpTarget& target);

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const MoveVertex&) const = default;
};

}  // namespace ryosen
