// How much of a surface is seen from its front, and how much from behind.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/base/progress.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct SeenArea {
  double front = 0, behind = 0;  // in units of one power of two for all patches

  bool is_mostly_behind() const { return behind > 1.5 * front; }
};

// The seen areas of patches of faces. A triangle of a face is seen from a side where the ray from its centre along the
// normal of that side meets nothing of the mesh; all of the triangle then counts. `patch` is by face slot, no_index for
// faces that are not asked for. O(n log n) where rays pass few boxes before they meet something. Cancelled: nothing is
// seen.
std::vector<SeenArea> seen_areas(const Mesh& mesh, const std::vector<std::uint32_t>& patch, std::uint32_t patches,
                                 Progress& progress);

}  // namespace ryosen
