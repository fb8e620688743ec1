// Along which side of a face each of some edges runs, so that edges that meet run on from each other where they may.
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// One side for each edge between two points, in the order in which they are named first: that of a face, the one on the
// left of the halfedge before others, or a halfedge of a wire. One that may run either way, a wire or an edge with a
// face on both sides, runs on from the other one where two alone meet. O(edges * log(edges)) and the sheets of the
// edges.
std::vector<Halfedge> sides_of(const Mesh& mesh, std::span<const Halfedge> edges);

}  // namespace ryosen
