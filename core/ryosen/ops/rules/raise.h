// Raises a region of faces on walls, as the polygon list says it, with the fans and edges that reading it would give.
#pragma once

#include "ryosen/ops/op.h"
#include "ryosen/ops/rules/region.h"

namespace ryosen {

// In the faces of the region each point that stays behind is replaced by a new one, moved by `by`; its other points are
// moved. Each edge a -> b of the border gets a wall (a, b, b', a'), in the order of the border. Cost: the corners of
// the region and the fans at the points that stay behind.
OpEffect raise(Edit& edit, const Region& region, const glm::dvec3& by);

}  // namespace ryosen
