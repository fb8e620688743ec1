// The account of a simplification: how many edges stand under which rule.
#pragma once

#include <vector>

#include "core/algo/simplify/simplifier.h"

namespace ryosen {

// By EdgeRule, of the edges of faces, counted on points as in figures: where an edge has several sheets, under the first
// rule that holds one of them. Cost: that of asking every edge.
std::vector<std::size_t> count_remaining(const Mesh& mesh, const Simplifier& simplifier);

}  // namespace ryosen
