// Takes edges away whose ends are at one place.
#pragma once

#include "ryosen/algo/repair/near_points.h"
#include "ryosen/base/progress.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Collapses edges between points with the same first one where this is sound (collapses_soundly); the lower number
// stays. `near` are the points of the mesh as it is. Returns how many.
std::size_t collapse_near(Edit& edit, const NearPoints& near, Progress& progress);

}  // namespace ryosen
