// Values of what operators unite, and shares by which an element is divided into parts, or parts count in what they are
// united to.
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/edit.h"

namespace ryosen {

// The values of two vertices as they unite at `along`, from the one that goes (0) to the one that stays (1); the nearer
// one comes first. Tells whether those of the one that stays have changed.
bool unite_ends(Edit& edit, Vertex gone, Vertex kept, double along);
// The areas of faces. O(their corners).
std::vector<double> areas_of(const Mesh& mesh, std::span<const Face> faces);
// The lengths of edges.
std::vector<double> lengths_of(const Mesh& mesh, std::span<const Edge> edges);
// The lengths of the two parts of an edge that is cut at this parameter, relative to its own; it may lie beyond its
// ends.
std::vector<double> lengths_of_parts(double along);

}  // namespace ryosen
