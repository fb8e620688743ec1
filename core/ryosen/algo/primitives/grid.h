// The primitive that is flat: a grid of quads, which lies as a floor.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// In the plane of X and Z, seen from above (+Y) counter-clockwise.
AlgorithmResult add_grid(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
