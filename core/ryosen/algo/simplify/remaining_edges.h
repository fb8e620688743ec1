// Counts the edges that a simplification left, by the rule that holds them.
#pragma once

#include <span>
#include <vector>

#include "ryosen/algo/simplify/simplifier.h"

namespace ryosen {

// By edge slot, as EdgeRule: the first rule that holds an edge of faces, that of the first of its sheets where its
// points have several; no_rule for every other slot, and of those left where it was cancelled. Cost: that of asking
// every edge.
std::vector<std::uint8_t> find_remaining(const Mesh& mesh, const Simplifier& simplifier, Progress& progress);
// How many edges stand under each, counted on points as in figures.
std::vector<std::size_t> count_remaining(const Mesh& mesh, std::span<const std::uint8_t> rules);

}  // namespace ryosen
