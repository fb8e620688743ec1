// The cuts and joins of links that operators are made of. Each leaves the cycles of `next` whole; faces of halfedges
// and starts of loops are the caller's where a comment does not say otherwise.
#pragma once

#include "core/mesh/edit.h"
#include "core/mesh/rings.h"

namespace ryosen {

// Puts an edge a -> b between the corner after `into_a` and the corner after `into_b`: the halfedges that arrive there,
// none at a vertex without edges. Returns the halfedge a -> b, outside.
//
//     into_a   after_a          into_a   after_a
//        \     /                    \  ^ /
//         > a >             =>       > a            after_a follows b -> a, a -> b follows into_a
//                                      |^
//         < b <                        v|           likewise at b
Halfedge link_edge(Edit& edit, Vertex a, Halfedge into_a, Vertex b, Halfedge into_b);

// Takes an edge out of the cycles it is on and deletes it; an end without another edge becomes isolated. Its ends may
// need hold_outside afterwards. The inverse of link_edge.
void unlink_edge(Edit& edit, Halfedge h);

// The same inside a face: between the corners after two of its sides. The edge has the face on both sides, its corners
// the values of those that it starts from.
Halfedge link_inside(Edit& edit, Halfedge into_a, Halfedge into_b);

// Takes a face and its rings away; all edges stay. Its corners lose their values. Cost: its corners.
void take_face_away(Edit& edit, Face f);

// Gives all halfedges of the cycle from `start` to a face, or to none.
void set_face_along(Edit& edit, Halfedge start, Face f);

// Lets v hold an outgoing outside halfedge if it has any; it must hold one of its own, or none. Cost: its valence.
void hold_outside(Edit& edit, Vertex v);

// Whether exactly two edges end at v.
bool has_two_edges(const Mesh& mesh, Vertex v);

// The outside halfedges that arrive at v: its gaps. One or more unless v is isolated or inside a surface.
std::vector<Halfedge> gaps_at(const Mesh& mesh, Vertex v);

}  // namespace ryosen
