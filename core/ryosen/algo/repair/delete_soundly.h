// Deleting faces without leaving a finding where there was none.
#pragma once

#include <vector>

#include "ryosen/mesh/edit.h"

namespace ryosen {

// Deletes faces, their edges that are left without a face, and vertices without an edge. A point that this makes
// non-manifold and an edge that it makes misoriented are taken apart (detach_points). Where two triangles would hang on
// each other (hanging_pair) without them, one of the faces at that edge stays, unless `may_leave_pairs`. Returns how
// many were deleted. Cost: O(k log k) for the k faces at the points of these faces.
std::size_t delete_soundly(Edit& edit, std::vector<Face> faces, bool may_leave_pairs = false);

}  // namespace ryosen
