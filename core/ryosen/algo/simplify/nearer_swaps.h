// Swaps of edges that bring a simplified surface nearer to what it was before.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/base/progress.h"
#include "ryosen/geometry/trees/triangle_tree.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// A surface of triangles as it was, scaled: what one that comes from it is compared with.
struct SurfaceBefore {
  struct Sample {
    glm::dvec3 place{0.0};
    double area = 0.0;  // that it stands for
  };

  TriangleTree triangles;
  std::vector<Sample> samples;  // corners and middles of the triangles
};

// O(n log n). Faces that are no triangles without rings, and those that lie at no finite place, are left out.
SurfaceBefore surface_before(const CollapseSurface& surface);

// Swaps edges between triangles where the squared distance between both surfaces, summed over the area of each, becomes
// less by it, in the order of the edges, until there is none or for a few rounds. What holds collapses holds swaps: no
// face turns too far or gets too small an angle, and creases, seams, copies and what is to stay are left alone. How
// many edges were swapped, and fewer where it was cancelled; the same for any number of threads. Cost: O(n log n),
// mostly for the nearest face of each sample.
std::size_t swap_nearer(Edit& edit, const CollapseSurface& surface, const SurfaceBefore& before, Progress& progress);

}  // namespace ryosen
