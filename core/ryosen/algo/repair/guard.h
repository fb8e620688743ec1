// The promise of every repair: it adds no finding of a kind that says the surface is unsound.
#pragma once

#include <array>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Elements in the mesh by kind, as ProblemSets counts them (of boundary loops their edges); 0 for kinds of the file.
using FindingCounts = std::array<std::size_t, most_problem_kinds>;

// O(corners), and a logarithm beside copies. `on_lines` as for ProblemSets.
FindingCounts count_findings(const Mesh& mesh, std::span<const Vertex> on_lines = {});

// Whether no repair may add to the kind: non-manifold and misoriented edges, non-manifold vertices, duplicates and
// faces without area. Boundary loops and isolated vertices may become more; so may hanging pairs among the duplicates,
// where other faces come off their edges; and duplicates by the pockets that close (pockets.h).
bool must_not_grow(const ProblemRow& row);

// Runs an algorithm. A repair that nevertheless adds to such a kind has `changed` 0, and in `left` what it changed: the
// edit is then not to be committed, as after any algorithm that changes nothing. `counts` are those of the mesh, and
// afterwards those of the mesh if it is committed. Cost: that of the algorithm, and O(n log n) for the counts.
AlgorithmResult run_guarded(Edit& edit, const AlgorithmRow& row, const AlgorithmInput& input, Progress& progress,
                            FindingCounts& counts);

}  // namespace ryosen
