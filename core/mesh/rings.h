// Rings: inner loops of a face.
//
//     o-----------------o        the outer loop runs counter-clockwise, a ring clockwise, so the face lies to the left
//     |    o-->--o      |        of both; the loops of a face share no vertex
//     |    |     | f    |
//     |    o--<--o      |        Mesh::first_ring(f) is the head of a chain in a side table, empty for ordinary meshes
//     o-----------------o
#pragma once

#include <vector>

#include "core/mesh/circulate.h"
#include "core/mesh/edit.h"

namespace ryosen {

// An edge with the same face on both sides: it joins two loops of the face, which are one list of corners (bridges.h).
inline bool is_bridge(const Mesh& mesh, Halfedge h) { return mesh.face(h) && mesh.face(h) == mesh.face(twin(h)); }

// Calls visit(start halfedge) for the outer loop and then for each ring.
template <class Visit>
void for_each_loop(const Mesh& mesh, Face f, Visit visit) {
  visit(mesh.halfedge(f));
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next) visit(mesh.ring(r).halfedge);
}

// The number of the ring whose loop h is on; no_index on an outer loop. Cost: the loop, and the rings of the face.
std::uint32_t ring_of(const Mesh& mesh, Halfedge h);

// Lets the loop that is known by `old` be known by `start` instead; false where none is. Cost: the rings of the face.
bool replace_start(Edit& edit, Face f, Halfedge old, Halfedge start);

// Every ring of the face belongs to `to` from here on. The halfedges keep their face until the caller sets it.
void move_rings(Edit& edit, Face from, Face to);

}  // namespace ryosen
