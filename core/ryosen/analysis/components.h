// Connected components of a mesh, on points and on vertices, and orientability.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"

namespace ryosen {

// Faces connected through shared edges (on points).
struct FaceComponents {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_face;  // per slot, components ordered by lowest face; no_index for dead slots
};
FaceComponents find_face_components(Neighbourhood& around);
// Only the number. O(edges).
std::uint32_t count_face_components(Neighbourhood& around);

// Whether the faces can be flipped so that all neighbours across edges with exactly two faces agree. O(edges).
bool is_orientable(Neighbourhood& around);
// A halfedge across which two faces cannot agree however faces are flipped; none if orientable.
Halfedge find_twist(Neighbourhood& around);

}  // namespace ryosen
