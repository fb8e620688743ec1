// Boundary loops that visit a place twice, parted there.
#pragma once

#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

// Parts each boundary loop that visits places more than once, so that each part visits a place once. Two holes that
// touch in a point are one loop while the fans of faces f and g between them have a vertex each, and two loops once
// these are one:
//
//        \ f /                 \ f /
//         v'                    \ /
//     A        B      =>     A   v   B
//         v''                   / \        A, B: holes
//        / g \                 / g \       f, g: fans of faces
//
// The vertices may also be two points at one place, as detaching leaves them. A loop stays whole where an edge of it
// has no or several faces, or a part would have fewer than three sides. Returns the vertices that two points have
// become. O(halfedges), and a sort of the places of the loops.
std::vector<Vertex> part_loops(Edit& edit);
// Gives each fan a vertex of its own again, and a point of its own where part_loops() has joined two. O(vertices).
void join_loops(Edit& edit, const std::vector<Vertex>& joined);

}  // namespace ryosen
