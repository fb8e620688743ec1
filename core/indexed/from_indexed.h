// Connects a polygon list into a halfedge mesh.
#pragma once

#include "core/indexed/indexed.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// Any list of simple polygons is accepted and nothing is dropped (duplicate faces included). Where more than two faces,
// or two in the same direction, run between two points, each gets an edge of its own; an outside loop of exactly two
// halves that this leaves is closed again. Each fan of faces at a point becomes a vertex: the one with the lowest face
// keeps the number of the point, further copies take numbers from positions.size() on, by point, then by lowest face.
// A face with an empty range (quarantined) holds a dead face number; the quarantine itself is not looked at. Corner lists must be in range and, but for
// the faces in `bridged`, without a repeated point; those become faces with rings. Cost: O(corners) plus sorting inside
// the few buckets of high valence. Positions are moved, not copied.
Mesh from_indexed(IndexedMesh source);

}  // namespace ryosen
