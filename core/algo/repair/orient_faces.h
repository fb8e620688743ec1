// Repair: turns faces so that neighbours agree.
#pragma once

#include "core/algo/repair/repairs.h"

namespace ryosen {

// As the operator orient, but two triangles on the same points that agree with each other and touch nothing else stay:
// turning one would make a hanging pair of them. O(n), beside copies O(n log n).
AlgorithmResult orient_faces(Edit& edit, const AlgorithmInput&, Progress& progress);

}  // namespace ryosen
