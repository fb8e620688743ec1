// Quick certainty for the ordinary edge: a collapse or swap among triangles that is legal or refused beyond doubt.
//
// Unknown means that the full judgement has to be asked: a polygon, a ring anywhere, a copy of a point, a vertex of
// several fans or wires, a high valence. Both are const walks without memory of their own, one or two cache lines per
// neighbour.
#pragma once

#include "core/mesh/mesh.h"

namespace ryosen {

enum class QuickAnswer { legal, refused, unknown };

// Whether the live edge of h may collapse, from the rings of both ends, gathered on the stack. O(valence).
QuickAnswer quick_collapse(const Mesh& mesh, Halfedge h);
// Whether it may be swapped, in either direction. O(valence of the vertex opposite to h).
QuickAnswer quick_swap(const Mesh& mesh, Halfedge h);

}  // namespace ryosen
