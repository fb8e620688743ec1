// Takes edges away whose ends are at one place.
#pragma once

#include "core/algo/repair/near_points.h"
#include "core/base/progress.h"
#include "core/mesh/edit.h"

namespace ryosen {

// Collapses edges between points with the same first one where this is sound (collapses_soundly); the lower number stays.
// `near` are the points of the mesh as it is. Returns how many.
std::size_t collapse_near(Edit& edit, const NearPoints& near, Progress& progress);

}  // namespace ryosen
