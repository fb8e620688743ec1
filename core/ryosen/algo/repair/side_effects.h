// What a repair has done beside its task: pieces that came off the surface, and faces that cross.
#pragma once

#include "ryosen/algo/algorithm.h"
#include "ryosen/analysis/components.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

FaceComponents components_of(const Mesh& mesh);

// Adds to what a repair has left the lowest faces of the open components that were part of a larger one before: of one
// that came apart every open piece but, where none of its pieces is closed, the one with the most faces, the first of
// equals. Faces that stay keep their numbers; a piece without a face from before counts for nothing. Ascending. O(n),
// beside copies O(n log n).
void add_loose_pieces(const FaceComponents& before, const Mesh& after, AlgorithmResult& result);
bool tells_of_loose_pieces(const LeftForReason& left);

// Adds to the result of an algorithm, and to its sentence, how many pairs of faces meet now that did not before. Cost:
// that of two searches for self-intersections.
void add_new_crossings(const Mesh& before, const Mesh& after, AlgorithmResult& result);

}  // namespace ryosen
