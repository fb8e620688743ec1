// The shares by which parts of an element take its sums.
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The areas of faces. O(their corners).
std::vector<double> areas_of(const Mesh& mesh, std::span<const Face> faces);
// The lengths of the two parts of an edge that is cut at this parameter, which may lie beyond its ends; its own is 1.
std::vector<double> lengths_of_parts(double along);

}  // namespace ryosen
