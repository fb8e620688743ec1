// Repair: removes faces without area.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Removes faces with exactly collinear corners, by the first of these that is sound, and the surface stays as it was
// but for the last two:
//  1. a side without length collapses;
//  2. a triangle gives its middle corner to the face across its long side, by a swap or by uniting the two;
//  3. a face at the border is deleted where this neither opens a boundary loop nor takes the surface apart;
//  4. two flat triangles swap their common long side for a shorter one, which makes another step possible;
//  5. a corner moves along the face onto another one, if that makes no other face flat and turns none;
//  6. the face is deleted, which opens a hole, and the surface is taken apart where it would not be manifold
//     (sound_changes.h). The text says how many boundary loops that opened.
// Each step removes a face, or shortens an edge (4). Cost: their one-rings, for a few rounds.
AlgorithmResult remove_degenerate_faces(Edit& edit, const AlgorithmInput&, Progress& progress);

// Removes those of the faces that have no area and a neighbour, in the ways 1 to 3 alone. Returns how many went.
std::size_t mend_degenerate_faces(Edit& edit, std::vector<Face> faces, Progress& progress);

}  // namespace ryosen
