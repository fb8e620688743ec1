// Dissolve: faces become one where an edge, or a vertex, stood between them.
//
//        d---x---c                d---x---c            d-------c                d-------c
//        | g |   |                |       |            | \   / |                |       |
//        |   y f |       =>       |       |            |   v   |       =>       |       |
//        |   |   |                |       |            | /   \ |                |       |
//        a---z---b                a---z---b            a-------b                a-------b
//
// on the list: of an edge: the two faces lose the chain that they share, the edges that follow one another through
//              vertices with exactly two edges, and become one. Of a vertex: all faces at it become one, its edges go
//              as such chains; inside it goes along, on the boundary only if what is then left of it are exactly two
//              edges that may become one (unite_edge). A vertex with exactly two edges from the start goes as by
//              unite_edge. The lowest number stays, with its material and groups; rings go along.
//              Corners that become one keep the values of the lowest-numbered face among theirs.
// needs: different faces that share these edges and touch nowhere else; no face is or was on the same points; the edges
//        are not cut and the vertices that go have no copies.
// changes: c edges and w vertices go, F - 1 of an edge (w = c - 1), F - k + 1 of a vertex with k faces; H, S, G, B stay.
// inverse: of an edge separate_loop and separate_edge, of a vertex inside poke.
#pragma once

#include "core/ops/op.h"

namespace ryosen {

struct Dissolve {
  Halfedge halfedge;   // the edge, or
  Vertex vertex = {};  // the vertex

  static constexpr OpInfo info{"dissolve",
                               "Dissolve",
                               "溶解",
                               "A-B|vN",
                               "unites the faces at an edge or around a vertex",
                               "稜線の両側または頂点の周りの面を一つにまとめる",
                               '\0',
                               OpTargetKind::edge,
                               "",
                               Topology::kept};

  static Parsed<Dissolve> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static Dissolve at(const Mesh& mesh, const OpTarget& target);
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
};

}  // namespace ryosen
