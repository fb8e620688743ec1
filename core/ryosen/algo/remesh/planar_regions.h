// Uniting planar regions into polygons with rings, and taking out the corners of polygons that lie on straight edges.
#pragma once

#include <cstddef>
#include <vector>

#include "ryosen/base/progress.h"
#include "ryosen/mesh/edit.h"

namespace ryosen::remesh {

struct PlanarOptions {
  // The normals of the faces of a region are within this of its first one's, and the parts of an edge of its direction.
  double angle_rad = 0.02;
  double distance = 0;  // and their points within this of its plane, or of the edge; 0: exactly on it
};

struct United {
  std::size_t regions = 0, faces = 0;  // regions of two faces or more that became one, and how many faces they had
  std::vector<Face> left;              // the first faces of regions that would touch themselves at a vertex
  bool is_cancelled = false;
};

// Regions grow from the largest face that is in none yet, over edges with two faces that agree in their values
// (material, group; texture) across them. Each becomes one face, the first of its numbers, whose loops are those of its
// border: the one with the largest projected area is the outer one, the others its rings. Points and edges inside are
// removed; those on the border stay. A closed surface has no border, so its last face stays out. O(n log n).
//
//     o---o---o           o---o---o
//     | / | / |           |       |
//     o---o---o    =>     o       o       all of it lies in one plane
//     | / | / |           |       |
//     o---o---o           o---o---o
United unite_planar(Edit& edit, const PlanarOptions& options, Progress& progress);

// Takes out vertices with two edges that lie on the straight line between those that stay, in the faces of both sides,
// where unite_edge may and no face loses its area. A vertex with more edges stays, and so does one with copies. Of a
// loop that has only vertices with two edges the first place in the order of coordinates and the one farthest from it
// stay. Returns how many went. O(n log n).
std::size_t drop_straight_corners(Edit& edit, const PlanarOptions& options, Progress& progress);

}  // namespace ryosen::remesh
