// Repairs that remove redundant elements: duplicate faces, isolated vertices.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Removes faces with the same loops of points as another, regardless of direction and start, where that opens no edge:
// the wall between two closed parts stays, of others the lowest. Faces with the same points in a different cyclic order
// have another shape and stay. Where this leaves an edge with two faces in the same direction the surface is taken
// apart (sound_changes.h). O(n log n).
AlgorithmResult remove_duplicate_faces(Edit& edit, const AlgorithmInput&, Progress&);

// Removes vertices without an edge.
AlgorithmResult remove_isolated_vertices(Edit& edit, const AlgorithmInput&, Progress&);

}  // namespace ryosen
