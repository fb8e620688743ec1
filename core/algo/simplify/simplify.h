// Simplification: fewer faces on nearly the same surface, by collapses of edges (simplifier.h).
#pragma once

#include <vector>

#include "core/algo/algorithms.h"

namespace ryosen {

// To a number of faces, a share of them, or an error, whichever comes first. Vertices and faces that stay keep their
// numbers. Cost: O(n) and a constant number of questions per collapse.
AlgorithmResult simplify(Edit& edit, const AlgorithmInput& input, Progress& progress);

std::vector<AlgorithmRow> simplify_rows();

}  // namespace ryosen
