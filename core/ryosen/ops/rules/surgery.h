// Low-level link surgery for operators. Each function leaves `next` a valid permutation; faces of halfedges and starts
// of loops are the caller's responsibility unless stated otherwise.
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

// Inserts an edge a -> b between the corner after `into_a` and the corner after `into_b`: the incoming halfedges there,
// none at an isolated vertex. Returns the halfedge a -> b, without a face.
//
//     into_a   after_a          into_a   after_a
//        \     /                    \  ^ /
//         > a >             =>       > a            after_a follows b -> a, a -> b follows into_a
//                                      |^
//         < b <                        v|           likewise at b
Halfedge link_edge(Edit& edit, Vertex a, Halfedge into_a, Vertex b, Halfedge into_b);

// Unlinks an edge from its cycles and deletes it; an end without another edge becomes isolated. Its ends may need
// hold_outside afterwards. The inverse of link_edge.
void unlink_edge(Edit& edit, Halfedge h);

// link_edge inside a face, between the corners after two of its sides. The edge has the face on both sides; its corners
// get the values of the corners it starts from.
Halfedge link_inside(Edit& edit, Halfedge into_a, Halfedge into_b);

// Chains of edges between the same two faces, through vertices with exactly two edges. The chain from h on, h first.
std::vector<Halfedge> chain_from(const Mesh& mesh, Halfedge h);
// The whole chain that an edge lies in, in the direction of its twin; one that has no end begins with h.
std::vector<Halfedge> chain_through(const Mesh& mesh, Halfedge h);
// The vertices within a chain.
std::vector<Vertex> inner_vertices(const Mesh& mesh, std::span<const Halfedge> chain);

// Unites the two faces along a chain of edges into the lower one, without the chain; vertices within it become
// isolated. Returns the face that is gone.
Face unite_faces(Edit& edit, std::span<const Halfedge> chain);

// Deletes a face and its rings; all edges stay. Clears its corner values. Cost: its corners.
void take_face_away(Edit& edit, Face f);

// Sets the face (or none) of all halfedges of the cycle from `start`.
void set_face_along(Edit& edit, Halfedge start, Face f);
// Gives a face to halfedges that lay outside: their corners are new and have the defaults.
void fill_loop(Edit& edit, Halfedge start, Face f);

// Makes v store an outgoing boundary halfedge if it has any; it must already store an outgoing halfedge, or none. Cost:
// its valence.
void hold_outside(Edit& edit, Vertex v);

// Whether v has exactly two edges.
bool has_two_edges(const Mesh& mesh, Vertex v);

// The boundary halfedges that end at v: its gaps. Empty only if v is isolated or interior.
std::vector<Halfedge> gaps_at(const Mesh& mesh, Vertex v);

}  // namespace ryosen
