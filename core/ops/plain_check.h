// Quick certainty for the ordinary edge: a collapse or swap among triangles that is legal beyond doubt.
//
// The answer "no" only means that the full judgement has to be asked: a polygon, a ring anywhere, a copy of a point, a
// vertex of several fans or wires, a high valence, or a rule that stands against it. Both are const walks without memory of their own,
// one or two cache lines per neighbour.
#pragma once

#include "core/mesh/mesh.h"

namespace ryosen {

// Whether collapsing the live edge of h is certainly legal. Gathers the ring of one end on the stack and walks the
// other. O(valence).
bool is_surely_legal_collapse(const Mesh& mesh, Halfedge h);
// Whether swapping it, in either direction, is certainly legal. O(valence of the vertex opposite to h).
bool is_surely_legal_swap(const Mesh& mesh, Halfedge h);

}  // namespace ryosen
