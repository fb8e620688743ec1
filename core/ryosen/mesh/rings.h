// Rings: inner loops of a face.
//
//     o-----------------o        the outer loop runs counter-clockwise, a ring clockwise, so the face lies to the left
//     |    o-->--o      |        of both; the loops of a face share no vertex
//     |    |     | f    |
//     |    o--<--o      |        Mesh::first_ring(f) is the head of a chain in a side table, empty for ordinary meshes
//     o-----------------o
#pragma once

#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Whether the edge has the same face on both sides; it merges two loops of the face into one corner list (bridges.h).
inline bool is_bridge(const Mesh& mesh, Halfedge h) { return mesh.face(h) && mesh.face(h) == mesh.face(twin(h)); }

// Calls visit(start halfedge) for the outer loop and then for each ring.
template <class Visit>
void for_each_loop(const Mesh& mesh, Face f, Visit visit) {
  visit(mesh.halfedge(f));
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next) visit(mesh.ring(r).halfedge);
}

// The number of the ring that h belongs to; no_index if on the outer loop. Cost: the loop, plus r log r for r rings.
std::uint32_t ring_of(const Mesh& mesh, Halfedge h);

// If `old` is the stored start of one of the face's loops, stores `start` instead; else returns false. Cost: the rings
// of the face.
bool replace_start(Edit& edit, Face f, Halfedge old, Halfedge start);

// Moves all rings of face `from` to face `to`. Does not set the face of their halfedges: the caller does.
void move_rings(Edit& edit, Face from, Face to);

}  // namespace ryosen
