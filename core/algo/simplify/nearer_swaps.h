// Swaps of edges that bring a simplified surface nearer to what it was before.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/algo/simplify/collapse_surface.h"
#include "core/base/progress.h"
#include "core/mesh/edit.h"

namespace ryosen {

// Places all over a surface, scaled: its vertices and the middles of its triangles. O(n).
std::vector<glm::dvec3> sample_places(const CollapseSurface& surface);

// Swaps edges between triangles where the sum of the squared distances of these places becomes less by it, in the order of
// the edges, until there is none or for a few rounds. What holds collapses holds swaps: no face turns too far or gets too
// small an angle, and creases, seams, copies and what is to stay are left alone. How many edges were swapped, and fewer
// where it was cancelled; the same for any number of threads. Cost: O(n log n), mostly for the nearest face of each place.
std::size_t swap_nearer(Edit& edit, const CollapseSurface& surface, const std::vector<glm::dvec3>& samples,
                        Progress& progress);

}  // namespace ryosen
