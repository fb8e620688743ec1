// Places for vertices that have none: whose coordinates are no finite numbers.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Puts each in the middle of its neighbours that have a place, then those beside it, and so on inwards. Where none of
// them has one the faces go, and so do faces that this would leave on a line. O(neighbours).
AlgorithmResult give_places(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
