// Points at one place, or close to each other.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

// By slot of a point the first point in file order that is no farther away than the distance and is itself a first one;
// the point itself where it is that, where its position is not finite, or where a wire ends at it. None for vertices that
// are no points. `point_of` is points_by_slot(). O(vertices).
std::vector<Vertex> first_points_within(const Mesh& mesh, const std::vector<Vertex>& point_of, double distance);

// Whether an edge without a face ends at a copy of the point.
bool ends_a_wire(const Mesh& mesh, Vertex point);

}  // namespace ryosen
