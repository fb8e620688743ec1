// Which points a transform moves, and by what share.
#pragma once

#include <span>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct MovedPoint {
  Vertex point;      // stands for all its copies
  double share = 1;  // of the transform
};

// The points of elements, ascending, each once.
std::vector<Vertex> points_of(const Mesh& mesh, std::span<const Element> elements);

// Points that are moved whole, and with a radius all others nearer to one of them than that, by a share that falls off
// smoothly with the distance: 1 at none, 0 at the radius. Ascending. Without a radius it costs the points, else it is
// O(n) and what is tried: points in neighbouring cells of a grid as wide as the radius.
std::vector<MovedPoint> moved_points(const Mesh& mesh, std::span<const Vertex> whole, double falloff_radius);

// Their mean; the origin of none.
glm::dvec3 middle_of(const Mesh& mesh, std::span<const Vertex> points);

}  // namespace ryosen
