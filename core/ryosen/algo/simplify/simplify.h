// Simplification: fewer faces on nearly the same surface, by collapses of edges (simplifier.h).
#pragma once

#include <memory>
#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/algo/simplify/detail_levels.h"

namespace ryosen {

// To a number of faces, a share of them, or an error, whichever comes first. Vertices and faces that stay keep their
// numbers. Cost: O(n) and a constant number of questions per collapse.
AlgorithmResult simplify(Edit& edit, const AlgorithmInput& input, Progress& progress);

// What simplify() does with these values, as levels of detail: from the mesh, triangulated where that is asked for, to
// the goal, or as far as it goes. The level with as many faces has the bytes of what simplify() makes of that goal, but
// for faces that look against the input, which levels leave as they are. Null with a clause where it cannot be done,
// without one where it was cancelled.
struct BuiltLevels {
  std::unique_ptr<DetailLevels> levels;
  std::optional<Text> refused = {};
};
BuiltLevels build_levels(const Mesh& mesh, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
