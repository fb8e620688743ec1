// How much room points have that are drawn at many places.
#pragma once

#include <cstddef>

#include "ryosen/geometry/box.h"

namespace ryosen {

// As if so many were even over a surface as large as the two longer sides of their bounds, in whole octaves, so that an
// edit seldom changes it; none where they are few (see Point).
double room_of_points(const Box& bounds, std::size_t count);

}  // namespace ryosen
