// Local search for intersecting faces, for the geometric warnings.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Two intersecting faces, the smaller number first.
using Crossing = std::pair<Face, Face>;

// The crossings of the given faces with each other and with the faces in their two-ring; ascending. Dead faces are
// skipped. With more than 5,000 corners in the two-ring nothing is searched. Cost: the faces there.
std::vector<Crossing> crossings_near(const Mesh& mesh, std::span<const Face> faces);

}  // namespace ryosen
