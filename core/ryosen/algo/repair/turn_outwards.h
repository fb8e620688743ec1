// Which faces are to be turned so that the surface looks outwards.
#pragma once

#include <vector>

#include "ryosen/base/progress.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Tells by face slot whether the patch of the face should turn; empty where none should. A patch is faces
// joined over edges of two faces. One that is closed is turned where its faces do not look outwards at even depth and
// inwards at odd depth inside other closed ones (nest_shells), so all shells that cross look outwards where nothing is
// around them. One that is open is turned where its area seen from behind is more than 1.5 times that from the front
// (seen_areas), unless a closed patch is joined to it. One that disagrees with itself, or has a corner without a place,
// is left. Turning twice does nothing. O(n log n), with what nest_shells and seen_areas cost beside that.
std::vector<bool> faces_to_turn_outwards(const Mesh& mesh, Progress& progress);

}  // namespace ryosen
