// Swap (flip): rotates an edge by one corner inside its two faces.
//
//        c                     c
//       / \                   /|\                                                          .
//      / L \                 / | \                                                         .
//     a --> b       =>      a L|R b        polygons: (a,b,c,..l) and (b,a,d,..r) become (c,..l,a,d) and (d,..r,b,c)
//      \ R /                 \ | /
//       \ /                   \|/
//        d                     d
//
// polygon list: face (a, b, c, ...) becomes (c, ..., a, d), face (b, a, d, ...) becomes (d, ..., b, c). `back` rotates
//               the other way: (a, b, ..., l) and (b, a, ..., r) become (r, b, ..., l) and (l, a, ..., r).
// needs: two different faces; the new edge does not exist yet; no face visits a point twice; no face gains or loses a
//        duplicate; the edge is manifold and consistently oriented on points.
// changes: no counts.
// inverse: swap of the new edge in the other direction.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

class LocalFacts;

struct SwapEdge {
  Halfedge halfedge;
  bool back = false;

  static const OpInfo info;

  static SwapEdge at(const Mesh&, const OpTarget& target) { return {target.halfedge, false}; }

  Verdict check(const Mesh& mesh) const;
  // For many questions about one mesh.
  Verdict check(const Mesh& mesh, LocalFacts& known) const;
  // The same verdict without the fast path, rule by rule; check() falls back to it, and tests compare both.
  Verdict judge(const Mesh& mesh) const;
  // check(mesh).legal() for batch work; the full check runs only if the fast path is undecided.
  bool is_legal(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const SwapEdge&) const = default;
};

}  // namespace ryosen
