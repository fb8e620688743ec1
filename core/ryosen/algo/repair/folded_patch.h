// Whether a patch meets itself.
#pragma once

#include "ryosen/algo/repair/hole_loop.h"

namespace ryosen {

// Exact, with corners at one place as one (find_patch_crossings). The patch must have no degenerate triangles. O(n log
// n + pairs of overlapping boxes, of which fans have few); O(n log n) for one that covers its projection once.
bool crosses_itself(const HolePatch& patch);

}  // namespace ryosen
