// Splits points with several fans of faces into one vertex per fan.
#pragma once

#include "core/mesh/columns.h"

namespace ryosen {

// Every halfedge must be linked, with the points as origins. The fan with the lowest face keeps the point's number,
// the others take new ones, by point, then by lowest face; the copies of a point become a cycle in next_copy.
// Cost: one walk around every vertex.
void separate_fans(MeshColumns& columns);

}  // namespace ryosen
