// Inserts a vertex into an edge, without cutting faces.
//
//             a-----------b       =>       a-----m-----b
//
// polygon list: every face and wire pair at the edge gets a corner, triangles too.
// needs: an edge that is no bridge.
// changes: V + 1, E + 1. All sheets of a non-manifold or misoriented edge are divided; the point has a copy on each.
// inverse: unite_edge.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

struct SeparateEdge {
  Halfedge halfedge;
  double along = 0.5;

  static constexpr OpInfo info{"separate_edge",
                               "Divide edge",
                               "稜線分割",
                               "A-B [t]",
                               "puts a vertex into an edge without cutting faces",
                               "面を切らずに稜線の途中に頂点を入れる",
                               '\0',
                               OpTargetKind::edge,
                               OpGroup::euler,
                               "semv",
                               Topology::kept,
                               Subject::points};

  static Parsed<SeparateEdge> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static SeparateEdge at(const Mesh&, const OpTarget& target) { return {target.halfedge, target.snapped_along()}; }
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
