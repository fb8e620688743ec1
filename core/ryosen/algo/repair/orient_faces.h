// Repair: turns faces so that neighbours agree and the surface looks outwards.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// As the operator orient, but two triangles on the same points that agree with each other and touch nothing else stay:
// turning one would make a hanging pair of them. Then whole patches are turned outwards: closed ones by their
// nesting, open ones by the side that is seen (seen_area.h), at the cost of these. Where turning would tear a closed
// part (pair_faces.h), non-manifold places are taken apart first.
AlgorithmResult orient_faces(Edit& edit, const AlgorithmInput&, Progress& progress);

// How many faces of patches that agree with themselves it would turn.
std::size_t count_turned_wrong(const Mesh& mesh, Progress& progress);

}  // namespace ryosen
