// Halfedge links from a regular pairing (no cuts).
#pragma once

#include "ryosen/indexed/pair_regular.h"
#include "ryosen/mesh/columns.h"

namespace ryosen {

// Fills halfedges, vertex_halfedge and face_halfedge. The latter two must have their final lengths; faces without
// corners are not written. Triangles are linked edge by edge, in memory order. O(corners).
void link_regular(const IndexedMesh& source, const RegularPairing& pairing, unsigned threads, MeshColumns& columns);

// Links a boundary halfedge whose fan is otherwise linked, and stores it at its origin.
void link_outside_half(MeshColumns& columns, Halfedge h);

}  // namespace ryosen
