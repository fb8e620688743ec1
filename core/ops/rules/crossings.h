// Faces that cut through faces nearby, for the geometric warnings.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

// Two faces that cut through each other, the smaller number first.
using Crossing = std::pair<Face, Face>;

// The crossings of the given faces with one another and with the faces within two rings of them; ascending. Dead faces
// are passed over. Where more than 5,000 corners lie so near, nothing is searched. Cost: the faces there.
std::vector<Crossing> crossings_near(const Mesh& mesh, std::span<const Face> faces);

}  // namespace ryosen
