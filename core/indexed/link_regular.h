// Links the halves of a pairing without cuts.
#pragma once

#include "core/indexed/pair_regular.h"
#include "core/mesh/columns.h"

namespace ryosen {

// Fills the halfedges, and what vertices and faces hold. The columns of vertices and faces must have their lengths; of a
// face without corners nothing is written. Triangles are linked edge by edge, in the order of memory. O(corners).
void link_regular(const IndexedMesh& source, const RegularPairing& pairing, unsigned threads, MeshColumns& columns);

// Links an outside half whose fan is linked but for its gap, and makes its origin hold it.
void link_outside_half(MeshColumns& columns, Halfedge h);

}  // namespace ryosen
