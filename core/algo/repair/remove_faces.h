// Repairs that remove redundant elements: duplicate faces, degenerate faces, isolated vertices.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Among faces with the same loops of points, regardless of direction and start, the lowest stays. Faces with the same
// points in a different cyclic order have another shape and stay. O(n log n).
AlgorithmResult remove_duplicate_faces(Edit& edit, const AlgorithmInput&, Progress&);

// Removes faces with exactly collinear corners, keeping the surface closed if possible: zero-length edges are
// collapsed, a flat triangle on the long edge of a neighbour gives its middle corner to it (by a swap or by uniting the
// two), and only the rest is deleted. Each step reduces the number of degenerate faces. Cost: their one-rings, for as
// many rounds as degenerate faces are chained.
AlgorithmResult remove_degenerate_faces(Edit& edit, const AlgorithmInput&, Progress& progress);

// Removes vertices without an edge.
AlgorithmResult remove_isolated_vertices(Edit& edit, const AlgorithmInput&, Progress&);

}  // namespace ryosen
