// Dissolve: removes an edge or a vertex and merges the faces at it.
//
//        d---x---c                d---x---c            d-------c                d-------c
//        | g |   |                |       |            | \   / |                |       |
//        |   y f |       =>       |       |            |   v   |       =>       |       |
//        |   |   |                |       |            | /   \ |                |       |
//        a---z---b                a---z---b            a-------b                a-------b
//
// polygon list: edge: the two faces lose their shared chain (edges connected through vertices with exactly two edges)
//               and are merged. Vertex: all faces at it are merged, its edges are removed as such chains; an interior
//               vertex is removed too, one on the boundary only if exactly two edges remain at it that may be united
//               (unite_edge). A vertex that has exactly two edges is removed as by unite_edge. The lowest number stays,
//               with its material and groups; rings are kept. Merged corners keep the values of the lowest-numbered of
//               their faces.
// needs: different faces that share these edges and touch nowhere else; no other face on the same points, before or
//        after; the edges are not cut and the removed vertices have no copies.
// changes: E - c, V - w; F - 1 for an edge (w = c - 1), F - k + 1 for a vertex with k faces; H, S, G, B stay.
// inverse: for an edge separate_loop and separate_edge, for an interior vertex poke.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

class LocalFacts;

// The edges between different ones of the selected faces, ascending.
std::vector<Element> edges_between_faces(const Mesh& mesh, std::span<const Element> selected);
inline constexpr InPlaceOf edges_of_faces_side_by_side{edges_between_faces, "faces side by side", "隣り合う面"};

// See dissolve_series.h.
std::unique_ptr<OpSeries> dissolves_in_series(Edit& edit);

struct Dissolve {
  Halfedge halfedge;   // the edge, or
  Vertex vertex = {};  // the vertex

  static const OpInfo info;

  static Dissolve at(const Mesh&, const OpTarget& target) { return {target.halfedge}; }

  Verdict check(const Mesh& mesh) const;
  // For many questions about one mesh.
  Verdict check(const Mesh& mesh, LocalFacts& known) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const Dissolve&) const = default;
};

// Dissolves the sides of a face beyond which lie different other ones (whose halfedges these are), if this is legal for
// all together and no end of a side goes with it; else does nothing and returns false. O(n log n) in the corners of the
// faces, where one after the other would read the common face each time.
bool dissolve_together(Edit& edit, std::vector<Halfedge> sides);

}  // namespace ryosen
