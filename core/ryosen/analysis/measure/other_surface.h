// The surface of another mesh, from which the vertices of a mesh are measured one by one.
#pragma once

#include <glm/vec3.hpp>

#include "ryosen/analysis/measure/measured_surface.h"

namespace ryosen {

// Keeps what it needs of the mesh, which may change or go afterwards. O(n log n) to make.
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
