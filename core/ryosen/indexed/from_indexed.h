// Conversion of a polygon list to a halfedge mesh.
#pragma once

#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Any list of simple polygons is accepted and nothing is dropped (duplicate faces included). If more than two faces, or
// two in the same direction, share a pair of points, each gets an edge of its own; a boundary loop of exactly two
// halfedges that results is closed again. Each fan of faces at a point becomes a vertex: the one with the lowest face
// keeps the number of the point, further copies are numbered from positions.size() on, by point, then by lowest face. A
// face with an empty range (quarantined) gets a dead face slot; the quarantine itself is not read. Corner lists must be
// in range and without a repeated point, except those of faces in `bridged`, which become faces with rings. Cost:
// O(corners) plus sorting in the few buckets of high valence. Positions are moved, not copied.
Mesh from_indexed(IndexedMesh source);

}  // namespace ryosen
