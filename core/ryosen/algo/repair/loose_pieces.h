// Pieces of the surface that a repair has taken off.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/analysis/components.h"

namespace ryosen {

FaceComponents components_of(const Mesh& mesh);

// The lowest faces of the open components that were part of a larger one before: of one that came apart every open
// piece but, where none of its pieces is closed, the one with the most faces, the first of equals. Faces that stay keep
// their numbers; a piece without a face from before counts for nothing. Ascending. O(n), beside copies O(n log n).
std::vector<Face> find_loose_pieces(const FaceComponents& before, const Mesh& after);

// Adds them to what a repair has left.
void add_loose_pieces(const FaceComponents& before, const Mesh& after, AlgorithmResult& result);
bool tells_of_loose_pieces(const LeftForReason& left);

}  // namespace ryosen
