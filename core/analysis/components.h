// Connected parts of a mesh, on points and in the kernel, and whether its faces can be turned to agree.
#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/neighbourhood.h"

namespace ryosen {

// Faces joined through any edge on points that they share.
struct FaceComponents {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_face;  // per slot, numbered by lowest face; no_index for dead slots
};
FaceComponents find_face_components(Neighbourhood& around);
// Only how many. O(edges).
std::uint32_t count_face_components(Neighbourhood& around);

// Whether the faces joined through edges with exactly two faces can be turned so that all agree. O(edges).
bool is_orientable(Neighbourhood& around);
// A halfedge across which they cannot, however the others are turned; none where they can.
Halfedge find_twist(Neighbourhood& around);

}  // namespace ryosen
