// The surface of a mesh as what is measured: the closed set of its triangles.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
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

// The surface of another mesh, from which the vertices of a mesh are measured one by one. Keeps what it needs of the
// mesh, which may change or go afterwards. O(n log n) to make.
class OtherSurface {
 public:
  explicit OtherSurface(const Mesh& mesh);

  // From the nearest point of the surface, in units of the mesh; NaN for a place that is not finite, and where the mesh
  // had no face with finite corners. O(log n) where few triangles are as near.
  double distance(const glm::dvec3& place) const;

 private:
  double scale_ = 1;
  TriangleTree tree_;
};

}  // namespace ryosen
