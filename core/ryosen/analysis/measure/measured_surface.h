// The surface of a mesh as what is measured: the closed set of its triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/geometry/box.h"
#include "ryosen/geometry/trees/triangle_tree.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Polygons count as they are drawn, cut into triangles. Wires, isolated vertices and quarantined faces are no surface;
// faces with a corner that is not finite are left out and counted.
struct MeasuredSurface {
  const Mesh* mesh;
  std::vector<Primitive> triangles;  // owned by their faces
  std::size_t faces = 0, left_out = 0;
  Box box;  // of their corners

  explicit MeasuredSurface(const Mesh& mesh);
  // The largest magnitude of a coordinate of a corner.
  double reach() const;
  bool is_empty() const { return triangles.empty(); }
  TriangleTree tree(double scale) const { return TriangleTree(mesh->positions(), triangles, scale); }
};

// The power of two that brings coordinates of at most this magnitude to at most 1; 1 for 0.
double scale_for(double largest);

}  // namespace ryosen
