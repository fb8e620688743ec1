// Faces on the same set of points: duplicates and hanging pairs.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"

namespace ryosen {

// Whether a face with a smaller number has the same set of points. Cost: O(1) for triangles and quads without copies
// nearby, else the faces at the corner of lowest valence.
bool has_lower_equal_face(Neighbourhood& around, Face f);

// All faces for which has_lower_equal_face holds, ascending. O(corners log corners) worst case.
std::vector<std::uint32_t> find_duplicate_faces(Neighbourhood& around);

// Whether f and a triangle with a smaller number have the same three points in opposite order (back to back), and at
// least two of their edges have no third face.
bool closes_hanging_pair(Neighbourhood& around, Face f);
// The other triangle of the pair that f closes, or none.
Face hanging_partner(Neighbourhood& around, Face f);

}  // namespace ryosen
