// Swaps of edges that bring a simplified surface nearer to what it was before.
#pragma once

#include "ryosen/algo/simplify/distance_guard.h"
#include "ryosen/algo/simplify/near_samples.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Swaps edges between triangles where the squared distance between both surfaces, summed over the area of each, becomes
// less by it, in the order of the edges, until there is none or for a few rounds. What holds collapses holds swaps: no
// face turns too far or gets too small an angle, where there is a guard, nothing is swapped whose distance it cannot
// prove, and creases, seams, copies and what is to stay are left alone.
// `samples` are those of the input, assigned, and stay so; `input` is its tree. How many edges were swapped, and fewer
// where it was cancelled; the same for any number of threads. Cost: O(log n) for each edge that is asked.
std::size_t swap_nearer(Edit& edit, const CollapseSurface& surface, NearSamples& samples, const TriangleTree& input,
                        DistanceGuard* guard, Progress& progress);

}  // namespace ryosen
