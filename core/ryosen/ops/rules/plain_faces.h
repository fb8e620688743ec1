// Quick answers about the two faces at an edge: true where the operator is legal beyond doubt. Between questions the
// corners of large faces are remembered, so that one costs what is near the edge, not the size of the faces.
#pragma once

#include <span>

#include "ryosen/ops/rules/local_facts.h"

namespace ryosen {

// What is known of two different faces along a chain of edges that lie between them, through vertices with two edges.
enum class Union {
  plain,     // simple loops that touch at this chain alone, each the only one on its points, and no third face lies on
             // the points of both: they may be united
  touching,  // simple loops, each the only one on its points, that touch elsewhere too or would have too few corners
  unsure
};
// `looks` is added the corners that were looked at. Cost: those of the smaller face and the valence of one of its
// points, at most.
Union judge_union(const Mesh& mesh, std::span<const Halfedge> chain, LocalFacts& known, std::uint64_t* looks = nullptr);
// Whether the two faces at an edge may be united.
bool unite_plainly(const Mesh& mesh, Halfedge h, LocalFacts& known);

// One face of a swap: it loses one corner and gains another one.
struct CornerChange {
  Face face, beside;    // at the edge
  Vertex loses, stays;  // the ends of the edge
  Vertex gains;
};
// Whether the face is a simple loop and the only one on its points, does not touch the vertex that it gains, and no
// face but the one beside it can be on its points afterwards.
bool changes_plainly(const Mesh& mesh, const CornerChange& change, LocalFacts& known);

}  // namespace ryosen
