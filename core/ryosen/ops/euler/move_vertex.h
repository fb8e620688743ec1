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

  static constexpr OpInfo info{"move_vertex",
                               "Move vertex",
                               "頂点移動",
                               "vN X,Y,Z",
                               "moves a vertex and all its copies to a place",
                               "頂点をそのすべての複製とともに移動する",
                               '\0',
                               OpTargetKind::none,
                               OpGroup::euler,
                               "move",
                               Topology::kept};

  static Parsed<MoveVertex> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static MoveVertex at(const Mesh& mesh, const OpTarget& target);
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
