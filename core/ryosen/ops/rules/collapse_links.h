// What a collapse does to corners and links, whichever of its ends keeps its slot.
#pragma once

#include "ryosen/mesh/edit.h"
#include "ryosen/ops/op.h"

namespace ryosen {

// Interpolates corner values around the edge: corners in the same chart (up to seams) as a side take its value at
// `along`.
void blend_corners(Edit& edit, Halfedge h, double along);

// Deletes the edge of h and the triangles at it, so that both ends have one cycle. Gives a halfedge of it: the first
// after h, or beyond a free end of a wire. Which vertex the halfedges leave, and which one that vertex stores, is for
// the caller.
Halfedge take_edge_out(Edit& edit, Halfedge h, OpEffect& effect);

}  // namespace ryosen
