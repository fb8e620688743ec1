// A quick sufficient test that a patch does not cross itself.
#pragma once

#include "ryosen/algo/repair/hole_loop.h"

namespace ryosen {

// Whether the patch, seen along the axis nearest to its loop's normal, covers each point once: all its triangles are
// seen from the same side, and the loop is a simple polygon. Exact; such a patch nowhere meets itself but at shared
// corners and sides. O(n log n) and the overlaps of boxes of the loop's sides.
bool covers_once_in_projection(const HolePatch& patch);

}  // namespace ryosen
