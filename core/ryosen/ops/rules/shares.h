// Shares by which an element is divided into parts, or parts count in what they are
// united to.
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The areas of faces. O(their corners).
std::vector<double> areas_of(const Mesh& mesh, std::span<const Face> faces);
// The lengths of edges.
std::vector<double> lengths_of(const Mesh& mesh, std::span<const Edge> edges);
// The lengths of the two parts of an edge that is cut at this parameter, relative to its own; it may lie beyond its
// ends.
std::vector<double> lengths_of_parts(double along);

}  // namespace ryosen
