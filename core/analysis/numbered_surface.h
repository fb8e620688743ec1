// The triangles of a mesh with corners numbered by point.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/geometry/triangles_meet.h"
#include "core/mesh/mesh.h"
#include "core/pick/surface_triangles.h"

namespace ryosen {

// Refers to the mesh, which must not change.
class NumberedSurface {
 public:
  explicit NumberedSurface(const Mesh& mesh);

  std::uint32_t slots() const { return static_cast<std::uint32_t>(triangles_.triangles().size()); }
  Face face(std::uint32_t slot) const { return Face(triangles_.faces()[slot]); }
  // Copies of a point have the same number.
  NumberedTriangle triangle(std::uint32_t slot) const;
  // Whether the corners are collinear (exact); true for an unused slot.
  bool is_flat(std::uint32_t slot) const;
  // How many triangles have a corner at the point, by its number. O(triangles).
  std::vector<std::uint32_t> triangles_at_points() const;

  // A frame suited to floats: positions are translated by the origin, their median, then scaled to about one unit.
  const glm::dvec3& origin() const { return origin_; }
  double scale() const { return scale_; }
  // The cross product of two sides of a triangle in that frame, rounded: twice its area along its normal.
  glm::dvec3 scaled_normal(const NumberedTriangle& t) const;

 private:
  void choose_frame();
  std::uint32_t point(std::uint32_t vertex) const { return point_.empty() ? vertex : point_[vertex]; }

  const Mesh& mesh_;
  SurfaceTriangles triangles_;
  std::vector<std::uint32_t> point_;  // by vertex; empty while the mesh has no copies
  glm::dvec3 origin_{0.0};
  double scale_ = 1.0;
};

}  // namespace ryosen
