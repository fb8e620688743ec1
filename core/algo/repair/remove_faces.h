// Takes away faces that add nothing: duplicates, and those without area.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// Of all faces with the same loops of points, whichever way round and from whichever corner, the lowest stays. Faces on
// the same points in another order have another shape and are left. O(n log n).
AlgorithmResult remove_duplicate_faces(Edit& edit, const AlgorithmInput&, Progress&);

// Takes faces whose corners lie exactly on a line away, such that the surface stays closed where it can: an edge without
// length collapses, a triangle flat on the long edge of a neighbour gives its middle corner to that (by a swap or by
// uniting the two), and only what is left is deleted. Each step leaves one degenerate face less. Cost: their stars, for
// as many rounds as degenerate faces are chained.
AlgorithmResult remove_degenerate_faces(Edit& edit, const AlgorithmInput&, Progress& progress);

// Vertices without an edge.
AlgorithmResult remove_isolated_vertices(Edit& edit, const AlgorithmInput&, Progress&);

}  // namespace ryosen
