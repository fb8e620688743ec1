// Points at one place, or close to each other.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

// By slot of a point the first point in file order that is no farther away than the distance and is itself a first one;
// the point itself where it is that, where its position is not finite, or where a wire ends at it. None for vertices that
// are no points. Isolated points that are `used_elsewhere` (AlgorithmInput) are no first ones, since they stay in the file
// whatever becomes of them. `point_of` is points_by_slot(). O(vertices).
std::vector<Vertex> first_points_within(const Mesh& mesh, const std::vector<Vertex>& point_of, double distance,
                                        std::span<const Vertex> used_elsewhere);

// Whether no copy of the point has an edge.
bool is_isolated_point(const Mesh& mesh, Vertex point);

// Whether an edge without a face ends at a copy of the point.
bool ends_a_wire(const Mesh& mesh, Vertex point);

}  // namespace ryosen
