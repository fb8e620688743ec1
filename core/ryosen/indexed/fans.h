// Splitting of points with several fans of faces into one vertex per fan.
#pragma once

#include "ryosen/mesh/columns.h"

namespace ryosen {

// Every halfedge must be linked, with the points as origins. The fan with the lowest face keeps the point's number, the
// others get new ones, ordered by point, then by lowest face; the copies of a point form a cyclic list in next_copy.
// Cost: one walk around every vertex.
void separate_fans(MeshColumns& columns);

}  // namespace ryosen
